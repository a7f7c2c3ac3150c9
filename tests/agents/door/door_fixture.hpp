#pragma once

// A door on a board of this process, and devices that say just what a test has them say.
//
//   Device device = device();
//   device.say("(hello barrier \"" + token("barrier") + "\")");
//   EXPECT_EQ(device.hear(), "(welcome barrier)");

#include <cerrno>
#include <filesystem>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "agents/door/door.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/run_task.hpp"
#include "tests/scratch.hpp"

namespace pizarra::door {

// Runs the executor until the condition holds, also where nothing of the executor's says so; whether it did in time.
inline bool run_until(Executor& executor, const std::function<bool()>& condition, Duration patience = 60s) {
  const Time deadline = executor.now() + patience;
  bool met = false;
  while (!met && executor.now() < deadline) {
    bool looked = false;
    const Executor::TimerId timer = executor.call_at(executor.now() + 1ms, [&looked] { looked = true; });
    executor.run_until([&] { return looked || (met = condition()); });
    executor.cancel(timer);
  }
  return met;
}

// A socket connected to a port of this machine, with as much room for what it has not read as usual or as is said.
inline int connect_to(int port, int receive_bytes = 0) {
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_port = htons(static_cast<std::uint16_t>(port));
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (receive_bytes > 0) ::setsockopt(file, SOL_SOCKET, SO_RCVBUF, &receive_bytes, sizeof receive_bytes);
  if (::connect(file, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0) return file;
  ::close(file);
  return -1;
}

class Device {
 public:
  Device(Executor& executor, int file) : executor_(executor), file_(file) {}
  Device(Device&& other) noexcept
      : executor_(other.executor_), file_(std::exchange(other.file_, -1)), heard_(std::move(other.heard_)) {}
  Device& operator=(Device&&) = delete;
  ~Device() { close(); }

  void close() {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
  }
  void send(std::string_view bytes) {
    ASSERT_TRUE(run_until(executor_, [&] {
      const ssize_t sent = ::send(file_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (sent > 0) bytes.remove_prefix(static_cast<std::size_t>(sent));
      return bytes.empty() || (sent < 0 && errno != EAGAIN);
    }));
  }
  void say(const std::string& line) { send(line + "\n"); }
  // The next line; "end" when the door has closed the connection.
  std::string hear() {
    std::string line;
    const bool came = run_until(executor_, [&] { return receive(line); });
    return came ? line : "nothing";
  }
  std::string said(const std::string& line) {
    say(line);
    return hear();
  }

 private:
  bool receive(std::string& line) {
    char chunk[4096];
    const ssize_t count = ::recv(file_, chunk, sizeof chunk, MSG_DONTWAIT);
    if (count > 0) heard_.append(chunk, static_cast<std::size_t>(count));
    const std::size_t end = heard_.find('\n');
    if (end != std::string::npos) {
      line = heard_.substr(0, end);
      heard_.erase(0, end + 1);
      return true;
    }
    line = count == 0 ? "end" : "broken";
    return count == 0 || (count < 0 && errno != EAGAIN);
  }

  Executor& executor_;
  int file_;
  std::string heard_;
};

class DoorTest : public testing::Test {
 protected:
  DoorTest() : board_(executor_), here_(board_.view("test")) {
    std::filesystem::remove_all(keys_);
    declare("(relation blocked ((barrier symbol)))");
    declare("(relation turned ((table symbol) (degrees integer)) (key table))");
    declare("(relation secret ((what symbol)))");
    make_key("barrier", {{"blocked"}, {}, {"blocked", "turned"}, {}});
    make_key("table", {{"turned"}, {}, {"blocked", "turned"}, {}});
    open_door({.tcp = TcpPlace{"127.0.0.1", 0}});
  }

  void open_door(const Door::Places& places) {
    const auto view = [this](const Pass& pass) -> Result<std::unique_ptr<Board>> { return board_.view(pass.name); };
    const auto note = [this](const std::string& news) { news_.push_back(news); };
    door_.reset();
    door_ = Door::open({executor_, keys_, view, note}, places).value();
  }
  void make_key(const std::string& name, const wire::Permissions& may) {
    tokens_[name] = wire::make_keys(keys_, name, may).value().secret_key;
  }
  std::string hello(const std::string& name) { return "(hello " + name + " \"" + tokens_.at(name) + "\")"; }
  Device device() { return {executor_, connect_to(door_->port())}; }
  // Welcomed.
  Device device(const std::string& name) {
    Device made = device();
    EXPECT_EQ(made.said(hello(name)), "(welcome " + name + ")");
    return made;
  }

  void declare(const std::string& form) {
    const Relation relation = relation_from_datum(read_one(form).value()).value();
    ASSERT_TRUE(board_.declare("test", {relation}));
  }
  void tell(const std::string& fact) { ASSERT_TRUE(run(executor_, here_->tell(read_one(fact).value()))); }
  std::size_t count(const std::string& pattern) {
    return run(executor_, here_->facts(read_one(pattern).value())).value().size();
  }

  RealExecutor executor_;
  memory::MemoryBoard board_;
  std::unique_ptr<Board> here_;
  const std::string keys_ = scratch_folder() + "keys";
  std::map<std::string, std::string> tokens_;
  std::vector<std::string> news_;
  std::unique_ptr<Door> door_;
};

}  // namespace pizarra::door
