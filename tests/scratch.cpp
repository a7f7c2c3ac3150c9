#include "tests/scratch.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace pizarra {

namespace {

class Scratch {
 public:
  Scratch() {
    std::string made = (std::filesystem::temp_directory_path() / "pizarra-test-XXXXXX").string();
    if (mkdtemp(made.data()) == nullptr) throw std::system_error(errno, std::generic_category(), made);
    path_ = made + "/";
    setenv("TMPDIR", path_.c_str(), 1);
    setenv("XDG_RUNTIME_DIR", path_.c_str(), 1);
  }
  ~Scratch() {
    std::error_code gone_already;
    // A forked child that ends is not the end of the test.
    if (getpid() == maker_) std::filesystem::remove_all(path_, gone_already);
  }
  const std::string& path() const { return path_; }

 private:
  const pid_t maker_ = getpid();
  std::string path_;
};

}  // namespace

const std::string& scratch_folder() {
  static const Scratch scratch;
  return scratch.path();
}

}  // namespace pizarra
