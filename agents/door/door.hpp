#pragma once

// The text door: small devices that say lines come here, each with its own key and its own session with the board.
//
//   auto door = Door::open({executor, "keys", connect, say}, {.tcp = TcpPlace{"127.0.0.1", 7801}});
//   (*door)->port();
//
// Over TCP a session that has not begun within five seconds ends, and a line that is not understood ends the
// connection, behind one that says why: nothing of what a browser posts there is done. On a serial line it ends the
// session, and the next hello begins another. A device that comes again takes the place of its earlier session. 32
// connections are open at once at most.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/door/guest.hpp"
#include "agents/door/places.hpp"

namespace pizarra::door {

class Door {
 public:
  static constexpr std::size_t most_connections = 32;
  static constexpr Duration hello_within = 5s;

  struct Setup {
    Executor& executor;
    std::string keys;  // the folder
    // A session of its own for who has this pass.
    std::function<Result<std::unique_ptr<Board>>(const Pass& pass)> board;
    // What whoever runs the door should know.
    std::function<void(const std::string& news)> news;
  };
  struct Places {
    std::optional<TcpPlace> tcp = {};
    std::vector<SerialPlace> serial = {};
  };

  // Failures: bad-address, bad-baud. A serial line that is not there is waited for.
  static Result<std::unique_ptr<Door>> open(Setup setup, const Places& places);
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;
  ~Door();

  std::uint16_t port() const { return port_; }
  std::size_t sessions() const { return sessions_.size(); }

 private:
  struct Connection {
    Connection(Executor& executor, int file) : lines(executor, file) {}
    Lines lines;
    Job job;
  };

  explicit Door(Setup setup) : setup_(std::move(setup)) {}
  void accept();
  Task<void> receive(int number, Lines& lines);
  Task<void> serve_line(SerialPlace place);
  Task<void> serve(Lines& lines, std::optional<Time> deadline);
  Result<Guest::Admitted> admit(Lines& lines, const std::string& name, const std::string& token);
  void forget(const Lines& lines);
  void say_once(const std::string& news);

  const std::shared_ptr<int> alive_ = std::make_shared<int>(0);
  Setup setup_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::string said_;
  std::map<std::string, Lines*> sessions_;  // by the names of the devices
  int next_connection_ = 1;
  std::map<int, std::unique_ptr<Connection>> connections_;
  std::vector<Job> serial_;
};

}  // namespace pizarra::door
