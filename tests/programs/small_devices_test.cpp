// The example's light barrier and turntable, each a process at the end of a pseudo-terminal, through a text door that
// is a process too, or one of a cell: their facts, what becomes of these when a device or the door dies, and what their
// keys permit.

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

constexpr std::chrono::seconds patience{60};

// The words behind `beginning` in what a program said, up to the next blank.
std::string said_behind(const Running& program, const std::string& beginning) {
  EXPECT_TRUE(wait_until([&] { return program.said().contains(beginning); }, patience)) << program.said();
  const std::string said = program.said();
  const std::size_t begin = said.find(beginning) + beginning.size();
  return said.substr(begin, said.find_first_of(" \n", begin) - begin);
}

// A device, and what is typed at it.
class EmulatedDevice {
 public:
  EmulatedDevice(const std::string& program, const std::string& name, const std::string& token)
      : pipe_(scratch_folder() + name + ".typed") {
    std::filesystem::remove(pipe_);
    EXPECT_EQ(::mkfifo(pipe_.c_str(), 0600), 0);
    typed_ = ::open(pipe_.c_str(), O_RDWR | O_CLOEXEC);
    running_.emplace(std::vector<std::string>{"/bin/sh", "-c", "exec " + program + " '" + token + "' < " + pipe_},
                     scratch_folder() + name + ".log");
    line_ = said_behind(*running_, "at ");
  }
  EmulatedDevice(const EmulatedDevice&) = delete;
  EmulatedDevice& operator=(const EmulatedDevice&) = delete;
  ~EmulatedDevice() { ::close(typed_); }
  const std::string& line() const { return line_; }
  void type(const std::string& text) const {
    const std::string line = text + "\n";
    EXPECT_EQ(::write(typed_, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  Running& running() { return *running_; }

 private:
  std::string pipe_;
  int typed_ = -1;
  std::optional<Running> running_;
  std::string line_;
};

class SmallDevices : public testing::Test {
 protected:
  SmallDevices() {
    std::filesystem::remove_all(keys_);
    make("barrier-1", "--tell blocked,watching");
    make("table-1", "--tell turned --read turn-to");
  }
  void make(const std::string& name, const std::string& may) {
    ASSERT_EQ(shell(std::string(PIZARRA_KEYS) + " keys new " + name + " --dir " + keys_ + " " + may).status, 0);
  }
  // The second text of NAME.secret, as docs/small-devices.md says.
  std::string token(const std::string& name) {
    const std::string text = whole_file(keys_ + "/" + name + ".secret");
    const std::size_t end = text.rfind('"');
    const std::size_t begin = text.rfind('"', end - 1) + 1;
    return text.substr(begin, end - begin);
  }
  void open_board(const std::vector<std::string>& options) {
    std::vector<std::string> words = {PIZARRA_BOARD};
    words.insert(words.end(), options.begin(), options.end());
    board_.emplace(words, folder_ + "board.log");
    address_ = said_behind(*board_, "ready on ");
  }
  void open_door(const std::vector<std::string>& lines) {
    std::vector<std::string> words = {PIZARRA_DOOR, "door", "--keys", keys_, "--board", address_};
    for (const std::string& line : lines) words.insert(words.end(), {"--serial", line});
    door_.emplace(words, folder_ + "door.log");
  }
  // A word at the board.
  Said board(const std::string& word, const std::string& form) {
    return shell(std::string(PIZARRA_CELL) + " " + word + " --board " + address_ + key_ + " '" + form + "' 2>&1");
  }
  bool comes(const std::string& query, const std::string& answer) {
    return wait_until([&] { return contains(board("ask", query), answer); }, patience);
  }
  bool goes(const std::string& query) {
    return wait_until([&] { return board("ask", query).text == "no\n"; }, patience);
  }

  const std::string folder_ = scratch_folder();
  const std::string keys_ = folder_ + "device-keys";
  std::string key_;  // with which this test comes
  std::string address_;
  std::optional<Running> board_;
  std::optional<Running> door_;
};

TEST_F(SmallDevices, ABlockedBarrierStopsTheArmAndSoDoesOneThatNobodyWatchesUntilAPersonTakesItBack) {
  open_board({"--listen", "ipc://" + folder_ + "board.ipc"});
  Running guard({PIZARRA_SCHEME, "scheme", source_dir() + "/examples/11-devices/guard.scm", "--board", address_},
                folder_ + "guard.log");
  EXPECT_TRUE(comes("(rule guard nobody-watches ?)", "yes")) << guard.said();
  EXPECT_EQ(board("tell", "(agent robot robot \"localhost\")").status, 0);
  EXPECT_TRUE(comes("(stop guard ?why)", "nobody watches")) << guard.said();
  EmulatedDevice barrier(PIZARRA_LIGHT_BARRIER, "barrier", token("barrier-1"));
  open_door({barrier.line()});
  EXPECT_TRUE(comes("(watching ?b)", "?b = barrier-1")) << door_->said();
  EXPECT_EQ(board("retract", "(stop guard ?)").status, 0);
  barrier.type("block");
  EXPECT_TRUE(comes("(stop guard ?why)", "something is in the light barrier")) << door_->said();
  // Neither the free beam nor the guard's own end takes it back.
  barrier.type("free");
  EXPECT_TRUE(goes("(blocked ?b)"));
  guard.signal(SIGKILL);
  EXPECT_TRUE(goes("(rule guard ?rule ?)"));
  EXPECT_TRUE(comes("(stop guard ?why)", "something is in the light barrier"));
}

TEST_F(SmallDevices, WhatABarrierSawLastStandsWhenTheDoorDies) {
  open_board({"--listen", "ipc://" + folder_ + "board.ipc"});
  EmulatedDevice barrier(PIZARRA_LIGHT_BARRIER, "barrier", token("barrier-1"));
  open_door({barrier.line()});
  // The door dies with something in the beam, and another one comes.
  barrier.type("block");
  EXPECT_TRUE(comes("(blocked ?b)", "?b = barrier-1"));
  door_->signal(SIGKILL);
  EXPECT_TRUE(goes("(watching ?b)"));
  EXPECT_TRUE(comes("(blocked ?b)", "?b = barrier-1"));
  barrier.type("free");
  open_door({barrier.line()});
  EXPECT_TRUE(goes("(blocked ?b)")) << door_->said();
  EXPECT_TRUE(comes("(watching ?b)", "?b = barrier-1"));
  barrier.running().signal(SIGKILL);
  EXPECT_TRUE(goes("(watching ?b)"));
}

TEST_F(SmallDevices, ATurntableTurnsToWhereItIsToldAndSaysWhenItIsThere) {
  open_board({"--listen", "ipc://" + folder_ + "board.ipc"});
  EmulatedDevice table(PIZARRA_TURNTABLE, "table", token("table-1"));
  open_door({table.line()});
  EXPECT_TRUE(comes("(turned table-1 ?degrees)", "?degrees = 0")) << door_->said();
  EXPECT_EQ(board("tell", "(turn-to table-1 40)").status, 0);
  EXPECT_TRUE(comes("(turned table-1 ?degrees)", "?degrees = 40")) << door_->said();
  EXPECT_EQ(board("tell", "(turn-to table-1 25)").status, 0);
  EXPECT_TRUE(comes("(turned table-1 ?degrees)", "?degrees = 25"));
  table.type("end");
  EXPECT_EQ(table.running().end(patience), 0);
  EXPECT_TRUE(goes("(turned table-1 ?degrees)"));
}

TEST_F(SmallDevices, AKeyThatIsTakenAwayEndsWhatItsDeviceMayDo) {
  make("board", "");
  make("desk", "");
  open_board({"--listen", "tcp://127.0.0.1:*", "--keys", keys_});
  key_ = " --key " + keys_ + "/desk.secret";
  EmulatedDevice barrier(PIZARRA_LIGHT_BARRIER, "barrier", token("barrier-1"));
  open_door({barrier.line()});
  EXPECT_TRUE(comes("(watching ?b)", "?b = barrier-1")) << door_->said();
  std::filesystem::remove(keys_ + "/barrier-1.key");
  EXPECT_TRUE(goes("(watching ?b)")) << door_->said();
  barrier.type("block");
  EXPECT_EQ(board("ask", "(blocked ?b)").text, "no\n");
}

TEST_F(SmallDevices, ACellFileNamesTheDoorAndUpStartsItAgain) {
  EmulatedDevice barrier(PIZARRA_LIGHT_BARRIER, "barrier", token("barrier-1"));
  const std::string cell = folder_ + "door-cell.scm";
  std::ofstream(cell) << "(cell door-cell (door (tcp 0) (serial \"" << barrier.line()
                      << "\") (keys \"device-keys\")) (host \"localhost\" (agents planner)))";
  Running up({PIZARRA_CELL, "up", cell}, folder_ + "up.log");
  address_ = said_behind(up, "board       ");
  EXPECT_TRUE(comes("(watching ?b)", "?b = barrier-1")) << up.said();
  const std::string log = said_behind(up, "logs        ") + "/door.log";
  EXPECT_TRUE(wait_until([&] { return whole_file(log).contains("ready on 127.0.0.1:"); }, patience)) << whole_file(log);
  const std::string started = "door started as process ";
  const std::string killed = said_behind(up, started);
  ::kill(static_cast<pid_t>(std::stol(killed)), SIGKILL);
  const auto another = [&] { return up.said().rfind(started) != up.said().find(started); };
  EXPECT_TRUE(wait_until(another, patience)) << up.said();
  barrier.type("block");
  EXPECT_TRUE(comes("(blocked ?b)", "?b = barrier-1")) << up.said() << whole_file(log);
  up.signal(SIGINT);
  EXPECT_EQ(up.end(patience), 0) << up.said();
}

// The door and its devices come to the cell's address each with the device's key, also on the board's own host.
TEST_F(SmallDevices, ADoorOfACellWhoseBoardAsksForKeysLetsInWhoHasOne) {
  make("board", "");
  make("desk", "");
  EmulatedDevice barrier(PIZARRA_LIGHT_BARRIER, "barrier", token("barrier-1"));
  // An address that was free a moment ago.
  open_board({"--listen", "tcp://127.0.0.1:*", "--keys", keys_});
  board_.reset();
  const std::string cell = folder_ + "keyed-cell.scm";
  std::ofstream(cell) << "(cell keyed-cell (board \"localhost\" \"" << address_
                      << "\" (keys \"device-keys\")) (door (serial \"" << barrier.line()
                      << "\") (keys \"device-keys\")) (host \"localhost\" (agents planner)))";
  Running up({PIZARRA_CELL, "up", cell}, folder_ + "keyed-up.log");
  key_ = " --key " + keys_ + "/desk.secret";
  const std::string log = said_behind(up, "logs        ") + "/door.log";
  EXPECT_TRUE(comes("(watching ?b)", "?b = barrier-1")) << up.said() << whole_file(log);
  barrier.type("block");
  EXPECT_TRUE(comes("(blocked ?b)", "?b = barrier-1")) << whole_file(log);
  std::filesystem::remove(keys_ + "/barrier-1.key");
  EXPECT_TRUE(goes("(watching ?b)")) << whole_file(log);
  up.signal(SIGINT);
  EXPECT_EQ(up.end(patience), 0) << up.said();
}

TEST(DoorWord, RefusesPlacesThatOthersReachAndWhatIsNoPlace) {
  const std::string word = std::string(PIZARRA_DOOR) + " door --board ipc:///tmp/none --keys /tmp ";
  for (const char* place : {"0.0.0.0:7801", "192.168.0.2:7801"}) {
    const Said said = shell(word + "--tcp " + place + " 2>&1");
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said, "loopback alone")) << said.text;
  }
  EXPECT_EQ(shell(word + "--tcp here 2>&1").status, 2);
  EXPECT_EQ(shell(word + "--serial ttyUSB0 2>&1").status, 2);
  EXPECT_EQ(shell(word + "--serial /dev/ttyUSB0:12345 2>&1").status, 2);
  const Said keyless = shell(std::string(PIZARRA_DOOR) + " door --board ipc:///tmp/none --keys /tmp/no-such-keys 2>&1");
  EXPECT_EQ(keyless.status, 2);
  EXPECT_TRUE(contains(keyless, "the folder of keys /tmp/no-such-keys cannot be read")) << keyless.text;
}

TEST(DoorExample, TheGuardsStoryIsAsExpected) {
  const std::string folder = source_dir() + "/examples/11-devices/";
  const Said said =
      shell(std::string(PIZARRA_SCHEME) + " scheme " + folder + "guard.scm --try " + folder + "guard-test.scm 2>&1");
  EXPECT_EQ(said.status, 0) << said.text;
}

}  // namespace
}  // namespace pizarra::programs
