#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <zmq.hpp>

#include "blackboard/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"

extern char** environ;

namespace pizarra {
namespace {

// The program as a child, and what it printed.
class Program {
 public:
  explicit Program(std::vector<std::string> words) {
    words.insert(words.begin(), PIZARRA_BOARD_PROGRAM);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    EXPECT_EQ(posix_spawn(&child_, PIZARRA_BOARD_PROGRAM, &actions, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    output_ = ends[0];
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (child_ != 0) stop(SIGKILL);
    close(output_);
  }

  // The next line it prints; what there is when it ends.
  std::string line() {
    std::string line;
    for (char c = 0; read_char(c) && c != '\n';) line += c;
    return line;
  }
  std::string rest() {
    std::string rest;
    for (char c = 0; read_char(c);) rest += c;
    return rest;
  }
  // Every file that its memory shows: the program and the libraries it runs with.
  std::string mapped_files() const {
    std::ifstream maps("/proc/" + std::to_string(child_) + "/maps");
    return {std::istreambuf_iterator<char>(maps), {}};
  }
  // Its exit code, or minus the signal that ended it.
  int stop(int signal) {
    kill(child_, signal);
    return wait();
  }
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  bool read_char(char& c) const { return ::read(output_, &c, 1) == 1; }
  pid_t child_ = 0;
  int output_ = -1;
};

class BoardProgram : public testing::Test, public Wall {
 protected:
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return RemoteBoard::connect(executor_, address_, teller).value();
  }

  const std::vector<Relation> relations_ = {relation("(relation goal ((n integer)) (durable))"),
                                            relation("(relation seen ((n integer)))")};
  RealExecutor executor_;
  const std::string address_ = ipc_address();
  const std::string path_ = address_.substr(6);
};

TEST_F(BoardProgram, SaysThatItIsReadyServesAndStopsCleanly) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program({"--listen", address_, "--listen", "tcp://127.0.0.1:*"});
    const std::string ready = program.line();
    EXPECT_TRUE(ready.starts_with("pizarra-board: ready on " + address_ + " tcp://127.0.0.1:")) << ready;
    const auto alice = view("alice");
    EXPECT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
    EXPECT_EQ(symbol_of(run(alice->tell(read("(seen 1)")))), "ok");
    EXPECT_EQ(program.stop(signal), 0);
    EXPECT_EQ(program.rest(), "");
    EXPECT_FALSE(std::filesystem::exists(path_));
  }
}

TEST_F(BoardProgram, RunsWithoutOpenCvAndGuile) {
  Program program({"--listen", address_});
  program.line();
  const std::string files = program.mapped_files();
  EXPECT_NE(files.find("libzmq"), std::string::npos) << files;
  EXPECT_EQ(files.find("libopencv"), std::string::npos) << files;
  EXPECT_EQ(files.find("libguile"), std::string::npos) << files;
  EXPECT_EQ(program.stop(SIGTERM), 0);
}

TEST_F(BoardProgram, DurableFactsOutliveItsSuddenDeath) {
  const std::string journal = path_ + ".journal";
  {
    Program program({"--listen", address_, "--journal", journal});
    program.line();
    const auto alice = view("alice");
    ASSERT_EQ(symbol_of(run(alice->declare(relations_))), "ok");
    ASSERT_EQ(symbol_of(run(alice->tell(read("(goal 1)")))), "ok");
    ASSERT_EQ(symbol_of(run(alice->tell(read("(seen 1)")))), "ok");
    EXPECT_EQ(program.stop(SIGKILL), -SIGKILL);
  }
  Program program({"--listen", address_, "--journal", journal});
  program.line();
  const auto bob = view("bob");
  EXPECT_EQ(run(bob->facts(read("(goal ?n)")))->size(), 1U);
  EXPECT_TRUE(run(bob->facts(read("(seen ?n)")))->empty());
  EXPECT_EQ(program.stop(SIGTERM), 0);
  std::filesystem::remove(journal);
}

// The client's side of the wire, word by word, over a connection of its own.
Datum say(const std::string& address, const std::vector<std::string>& words) {
  zmq::context_t context(1);
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::rcvtimeo, 5000);
  socket.connect(address);
  zmq::message_t answer;
  for (const std::string& word : words) {
    socket.send(zmq::buffer(word));
    if (!socket.recv(answer)) return {};
  }
  return read(answer.to_string());
}

TEST_F(BoardProgram, ARequestWhoseAnswerWasLostInACrashIsNotDoneTwice) {
  const std::string journal = path_ + ".journal";
  const std::string declare = "(declare (relation goal ((n integer)) (durable)))";
  std::string session;
  std::string request;
  {
    Program program({"--listen", address_, "--journal", journal});
    program.line();
    session = std::to_string(say(address_, {"(hello \"alice\" 0)"})[1].integer());
    const std::string begin = "(request " + session;
    request = begin + " 3 (take (goal ?n) 0))";
    const Datum taken = say(address_, {"(hello \"alice\" " + session + ")", begin + " 1 " + declare + ")",
                                       begin + " 2 (transact () ((tell (goal 1) 0) (tell (goal 2) 0))))", request});
    ASSERT_EQ(taken[2][1][0][4], read("(goal 1)")) << write(taken);
    EXPECT_EQ(program.stop(SIGKILL), -SIGKILL);
  }
  Program program({"--listen", address_, "--journal", journal});
  program.line();
  EXPECT_TRUE(say(address_, {request}).is_form("unknown-session")) << "the client must learn that this is another life";
  EXPECT_TRUE(say(address_, {"(hello \"mallory\" " + session + ")"})[1] != read(session));
  const Datum again = say(address_, {"(hello \"alice\" " + session + ")", request});
  EXPECT_EQ(again[2][1][0][4], read("(goal 1)")) << write(again);
  const auto bob = view("bob");
  EXPECT_EQ(run(bob->facts(read("(goal ?n)")))->size(), 1U) << "the other one was not taken in its place";
  EXPECT_EQ(program.stop(SIGTERM), 0);
  std::filesystem::remove(journal);
}

TEST_F(BoardProgram, ItsExitCodesSayWhatWasWrong) {
  const auto code = [](std::vector<std::string> words) {
    Program program(std::move(words));
    EXPECT_NE(program.rest(), "");
    return program.wait();
  };
  EXPECT_EQ(code({"--help"}), 0);
  EXPECT_EQ(code({}), 2);
  EXPECT_EQ(code({"--listen", address_, "--dance"}), 2);
  EXPECT_EQ(code({"--listen", "nowhere"}), 3);
  EXPECT_EQ(code({"--listen", "tcp://0.0.0.0:5999"}), 3);
  EXPECT_EQ(code({"--listen", "\xff\xfe"}), 3);
  EXPECT_EQ(code({"--listen", address_, "--journal", "/no/such/folder/journal"}), 4);
  EXPECT_EQ(code({"--listen", address_, "--journal", path_ + ".none", "--history", "long"}), 2);
}

}  // namespace
}  // namespace pizarra
