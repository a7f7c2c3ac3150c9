// Whose pictures go when a console is started.

#include "programs/commands/picture_folder.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agents/console/picture_store.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

namespace files = std::filesystem;

int ended_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

class PictureFolderTest : public testing::Test {
 protected:
  PictureFolderTest() { files::create_directory(among_); }
  ~PictureFolderTest() override { files::remove_all(among_); }

  files::path folder_of(int pid, const std::string& name = "abc123") {
    files::path folder = among_ / fmt::format("pizarra-pictures-{}-{}", pid, name);
    files::create_directories(folder / "eyes");
    std::ofstream(folder / "eyes" / "1_1_1x1.jpg") << "a picture";
    std::ofstream(folder / "lock").put(' ');
    return folder;
  }

  const files::path among_ = scratch_folder() + "among";
};

TEST_F(PictureFolderTest, IsMadeAndGoesWithItsConsole) {
  std::string path;
  {
    const PictureFolder own(among_);
    path = own.path();
    EXPECT_TRUE(files::is_directory(path));
    std::ofstream(path + "/lock").put(' ');
  }
  EXPECT_FALSE(files::exists(path));
}

TEST_F(PictureFolderTest, RemovesWhatAConsoleLeftThatHasGone) {
  const files::path left = folder_of(ended_process());
  const PictureFolder own(among_);
  EXPECT_FALSE(files::exists(left));
}

TEST_F(PictureFolderTest, LeavesWhatIsInUseAndWhatIsOfOthers) {
  const files::path living = folder_of(getpid());
  const files::path locked = folder_of(ended_process(), "locked");
  VirtualExecutor executor;
  const auto store = console::PictureStore::open(executor, locked.string(), 1'000'000);
  ASSERT_TRUE(store);
  const files::path foreign = among_ / "pizarra-pictures-mine";
  files::create_directory(foreign);
  const files::path elsewhere = among_ / fmt::format("pizarra-pictures-{}-link", ended_process());
  files::create_directory_symlink(foreign, elsewhere);
  const PictureFolder own(among_);
  for (const files::path& stays : {living, locked, foreign, elsewhere}) EXPECT_TRUE(files::exists(stays)) << stays;
}

}  // namespace
}  // namespace pizarra::programs
