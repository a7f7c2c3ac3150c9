#include "tests/blackboard/link_proxy.hpp"

#include <cerrno>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace pizarra {

namespace {

constexpr std::size_t most_pending = 1 << 16;

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error("the path is too long: " + path);
  path.copy(address.sun_path, path.size());
  return address;
}

int new_socket() { return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0); }

const sockaddr* generic(const sockaddr_un& address) { return reinterpret_cast<const sockaddr*>(&address); }

struct Command {
  int link;
  LinkProxy::State state;
};

}  // namespace

LinkProxy::LinkProxy(const std::vector<std::string>& paths, std::string server) : server_(std::move(server)) {
  for (const std::string& path : paths) {
    const int listener = new_socket();
    const sockaddr_un address = address_of(path);
    if (bind(listener, generic(address), sizeof address) != 0 || listen(listener, 64) != 0) {
      throw std::runtime_error("cannot listen at " + path);
    }
    links_.push_back({path, listener});
  }
}

LinkProxy::~LinkProxy() {
  for (Connection& connection : connections_) connection.over = true;
  forget_ended();
  for (const Link& link : links_) {
    close(link.listener);
    unlink(link.path.c_str());
  }
}

void LinkProxy::command(int commands, int link, State state) {
  const Command command{link, state};
  if (write(commands, &command, sizeof command) != sizeof command) throw std::runtime_error("the links are gone");
}

bool LinkProxy::obey(int commands) {
  Command command{};
  if (read(commands, &command, sizeof command) != sizeof command) return false;
  const auto link = static_cast<std::size_t>(command.link);
  links_[link].state = command.state;
  for (Connection& connection : connections_) {
    if (connection.link == link && command.state == State::cut) connection.over = true;
  }
  return true;
}

void LinkProxy::accept(std::size_t link) {
  const int client = accept4(links_[link].listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (client < 0) return;
  const int server = new_socket();
  const sockaddr_un address = address_of(server_);
  const bool reached = links_[link].state != State::cut && connect(server, generic(address), sizeof address) == 0;
  connections_.push_back(Connection{.link = link, .ends = {client, server}});
  connections_.back().over = !reached;
}

void LinkProxy::pass_on(Connection& connection, int from) {
  char bytes[most_pending];
  std::string& pending = connection.pending[1 - from];
  if (pending.empty()) {
    const ssize_t got = read(connection.ends[from], bytes, sizeof bytes);
    if (got == 0 || (got < 0 && errno != EAGAIN)) connection.over = true;
    if (got > 0) pending.assign(bytes, static_cast<std::size_t>(got));
  }
  if (pending.empty()) return;
  const ssize_t put = send(connection.ends[1 - from], pending.data(), pending.size(), MSG_NOSIGNAL);
  if (put < 0 && errno != EAGAIN) connection.over = true;
  if (put > 0) pending.erase(0, static_cast<std::size_t>(put));
}

void LinkProxy::forget_ended() {
  std::erase_if(connections_, [](const Connection& connection) {
    if (connection.over) close(connection.ends[0]), close(connection.ends[1]);
    return connection.over;
  });
}

void LinkProxy::run(int commands) {
  while (true) {
    std::vector<pollfd> polled = {{commands, POLLIN, 0}};
    for (const Link& link : links_) polled.push_back({link.listener, POLLIN, 0});
    for (const Connection& connection : connections_) {
      const bool silent = links_[connection.link].state == State::silent;
      for (int end = 0; end < 2; ++end) {
        const bool reading = connection.pending[1 - end].empty();
        const bool writing = !connection.pending[end].empty();
        const auto wanted = static_cast<short>((reading ? POLLIN : 0) | (writing ? POLLOUT : 0));
        // A negative file is passed over.
        polled.push_back({silent ? -1 : connection.ends[end], wanted, 0});
      }
    }
    if (poll(polled.data(), polled.size(), -1) < 0) continue;
    auto next = polled.begin() + static_cast<std::ptrdiff_t>(1 + links_.size());
    for (Connection& connection : connections_) {
      const bool stirred = next[0].revents != 0 || next[1].revents != 0;
      next += 2;
      if (stirred) pass_on(connection, 0), pass_on(connection, 1);
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      if (polled[1 + i].revents != 0) accept(i);
    }
    if (polled[0].revents != 0 && !obey(commands)) return;
    forget_ended();
  }
}

}  // namespace pizarra
