// The examples' drivers as plug-ins of a running cell: an arm that the robot agent drives and a camera that the eyes
// look through, started again, and refused from where others may write.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{60};

Said cell(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }

bool comes(const std::string& words, const std::string& text) {
  return wait_until([&] { return contains(cell(words), text); }, patience);
}

// A folder of plug-ins that holds this one under that name.
std::string folder_with(const std::string& library, const std::string& name = "libmyarm.so") {
  const std::string folder = scratch_folder() + "plugins-" + fs::path(library).stem().string();
  fs::create_directories(folder);
  fs::copy_file(library, folder + "/" + name, fs::copy_options::overwrite_existing);
  fs::permissions(folder, fs::perms(0755));
  fs::permissions(folder + "/" + name, fs::perms(0755));
  return folder;
}

Said plugin(const std::string& words) {
  return shell("timeout 20 " + std::string(PIZARRA_PLUGIN) + " " + words + " --listen ipc://" + scratch_folder() +
               "plugin.ipc 2>&1");
}

void kill_process(const std::string& name) {
  const std::string processes = cell("ps --json").text;
  const std::size_t line = processes.find("\"name\":\"" + name + "\"");
  ASSERT_NE(line, std::string::npos) << processes;
  const auto pid = std::strtol(processes.c_str() + processes.find("\"pid\":", line) + 6, nullptr, 10);
  ASSERT_GT(pid, 1);
  kill(static_cast<pid_t>(pid), SIGKILL);
}

TEST(Plugin, DrivesItsArmInAProcessOfItsOwnAndIsStartedAgain) {
  setenv("PIZARRA_PLUGINS", folder_with(PIZARRA_MY_ARM).c_str(), 1);
  Running up({PIZARRA_CELL, "up", source_dir() + "/examples/own-driver/cell.scm"}, scratch_folder() + "up.log");
  EXPECT_TRUE(comes("ask '(arm robot ?state ?action)'", "?state = idle")) << up.said();
  EXPECT_EQ(cell("tell '(request r1 robot (turn left 20))'").status, 0);
  EXPECT_TRUE(comes("ask '(reply r1 ?answer)'", "?answer = (ok true)"))
      << cell("ask '(reply r1 ?a)'").text << up.said();

  // A stop comes through while it moves.
  EXPECT_EQ(cell("tell '(request r2 robot (turn right 100))'").status, 0);
  EXPECT_TRUE(comes("ask '(arm robot moving ?action)'", "?action = ")) << up.said();
  EXPECT_EQ(cell("tell '(stop me \"wait\")'").status, 0);
  EXPECT_TRUE(comes("ask '(arm robot ?state ?action)'", "?state = stopped") ||
              comes("ask '(arm robot ?state ?action)'", "?state = idle"))
      << up.said();
  EXPECT_FALSE(contains(cell("ask '(reply r2 ?answer)'"), "(ok true)"));
  EXPECT_EQ(cell("retract '(stop me ?)'").status, 0);

  kill_process("arm-plugin");
  EXPECT_TRUE(wait_until([&] { return up.said().find("starts again") != std::string::npos; }, patience)) << up.said();
  // Nobody takes control of an arm that began anew but who says so.
  const auto obeys = [asked = 2]() mutable {
    const auto answer = [&asked](const std::string& operation) {
      const std::string id = "r" + std::to_string(++asked);
      cell("tell '(request " + id + " robot " + operation + ")'");
      comes("ask '(reply " + id + " ?answer)'", "?answer = ");
      return cell("ask '(reply " + id + " ?answer)'");
    };
    return contains(answer("(turn left 5)"), "not-in-control") && contains(answer("(get-control)"), "(ok") &&
           contains(answer("(turn left 5)"), "(ok true)");
  };
  EXPECT_TRUE(wait_until(obeys, patience)) << cell("ask '(reply ?r ?answer)'").text << up.said();
  up.signal(SIGINT);
  EXPECT_EQ(up.end(patience), 0) << up.said();
}

TEST(Plugin, ShowsTheEyesWhatItsCameraSeesAndIsStartedAgain) {
  setenv("PIZARRA_PLUGINS", folder_with(PIZARRA_MY_CAMERA, "libmycamera.so").c_str(), 1);
  Running up({PIZARRA_CELL, "up", source_dir() + "/examples/own-driver/camera.scm"}, scratch_folder() + "up.log");
  EXPECT_TRUE(comes("ask '(agent vision ?kind ?host)'", "?kind = vision")) << up.said();
  // A square of 48 pixels stands between 170 and 190 in the left image.
  const std::string asked[] = {"(connect)", "(learn 180 120 \"square\")", "(track \"square\")", "(keep)"};
  for (int number = 0; const std::string& operation : asked) {
    const std::string id = "r" + std::to_string(++number);
    EXPECT_EQ(cell("tell '(request " + id + " vision " + operation + ")'").status, 0);
    EXPECT_TRUE(comes("ask '(reply " + id + " ?answer)'", "?answer = (ok")) << up.said();
  }
  EXPECT_TRUE(comes("ask '(camera-model vision ?w ?h ?f ?x ?y ?base)'", "?f = 431")) << up.said();
  EXPECT_TRUE(comes("ask '(tracked vision ?name ?state ?frame ?c)'", "?state = seen")) << up.said();
  // 431 pixels and 90 mm over a disparity of 40 pixels.
  EXPECT_TRUE(comes("ask '(look vision ?frame ?text ?of)'", "(range 969."))
      << cell("ask '(look vision ?f ?t ?o)'").text;

  kill_process("camera-plugin");
  EXPECT_TRUE(wait_until([&] { return contains({0, up.said()}, "vision has images again"); }, patience)) << up.said();
  EXPECT_TRUE(comes("ask '(tracked vision ?name ?state ?frame ?c)'", "?state = seen")) << up.said();
  EXPECT_TRUE(comes("ask '(camera-state vision ?state ?trouble)'", "?state = open")) << up.said();
  up.signal(SIGINT);
  EXPECT_EQ(up.end(patience), 0) << up.said();
}

TEST(Plugin, IsLoadedOnlyFromWhereOthersCannotWrite) {
  const std::string folder = folder_with(PIZARRA_MY_ARM);
  fs::permissions(folder, fs::perms(0777));
  const Said open_folder = plugin("arm libmyarm.so --plugins " + folder);
  EXPECT_EQ(open_folder.status, 2) << open_folder.text;
  EXPECT_TRUE(contains(open_folder, "others may write to it")) << open_folder.text;
  fs::permissions(folder, fs::perms(0755));
  fs::permissions(folder + "/libmyarm.so", fs::perms(0775));
  EXPECT_TRUE(contains(plugin("arm libmyarm.so --plugins " + folder), "others may write to it"));
  fs::permissions(folder + "/libmyarm.so", fs::perms(0755));
  fs::create_symlink(folder + "/libmyarm.so", folder + "/other.so");
  EXPECT_EQ(plugin("arm ../libmyarm.so --plugins " + folder).status, 2);
  EXPECT_EQ(plugin("arm " + folder + "/libmyarm.so --plugins " + folder).status, 2);
  const Said none = plugin("arm libnone.so --plugins " + folder);
  EXPECT_EQ(none.status, 2);
  EXPECT_TRUE(contains(none, "there is no plug-in libnone.so")) << none.text;
}

TEST(Plugin, OfAnotherAbiOrKindIsRefused) {
  const Said old = plugin("arm libmyarm.so --plugins " + folder_with(PIZARRA_OLD_PLUGIN));
  EXPECT_EQ(old.status, 2);
  EXPECT_TRUE(contains(old, "built for plug-ins of the ABI 99")) << old.text;
  const Said other = plugin("camera libmyarm.so --plugins " + folder_with(PIZARRA_MY_ARM));
  EXPECT_EQ(other.status, 2);
  EXPECT_TRUE(contains(other, "has no pizarra_make_camera")) << other.text;
  const std::string folder = folder_with(PIZARRA_MY_ARM);
  std::ofstream(folder + "/libmyarm.so") << "no library";
  EXPECT_EQ(plugin("arm libmyarm.so --plugins " + folder).status, 2);
}

}  // namespace
}  // namespace pizarra::programs
