#pragma once

// Links that can be cut: each listens at a path of its own and passes on, byte by byte, what goes between its clients
// and the server at another path.
//
//   LinkProxy proxy({"/tmp/x/link-0", "/tmp/x/link-1"}, "/tmp/x/board.ipc");
//   proxy.run(commands);                      // in a process or thread of its own, until `commands` is closed
//   LinkProxy::command(other_end, 1, LinkProxy::State::cut);
//
// A cut link ends its connections and every new one. A silent one keeps them, and passes nothing on: what it was given
// waits until it is whole again.

#include <list>
#include <string>
#include <vector>

namespace pizarra {

class LinkProxy {
 public:
  enum class State : int { whole, cut, silent };

  LinkProxy(const std::vector<std::string>& paths, std::string server);
  LinkProxy(const LinkProxy&) = delete;
  LinkProxy& operator=(const LinkProxy&) = delete;
  ~LinkProxy();

  void run(int commands);
  static void command(int commands, int link, State state);

 private:
  struct Link {
    std::string path;
    int listener = -1;
    State state = State::whole;
  };
  struct Connection {
    std::size_t link;
    int ends[2];               // the client's and the server's
    std::string pending[2]{};  // for each of them
    bool over = false;
  };
  bool obey(int commands);
  void accept(std::size_t link);
  void pass_on(Connection& connection, int from);
  void forget_ended();

  const std::string server_;
  std::vector<Link> links_;
  std::list<Connection> connections_;
};

}  // namespace pizarra
