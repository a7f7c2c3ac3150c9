#include "agents/door/door.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include "drivers/line/serial_wire.hpp"
#include "drivers/line/tcp_port.hpp"

namespace pizarra::door {

namespace {

constexpr Duration look_for_line = 1s;
constexpr std::size_t most_refused = 32;  // connections that are being told that there are too many
constexpr int kernel_buffer = 32 << 10;

}  // namespace

Result<std::unique_ptr<Door>> Door::open(Setup setup, const Places& places) {
  std::unique_ptr<Door> door(new Door(std::move(setup)));
  Executor& executor = door->setup_.executor;
  for (const SerialPlace& place : places.serial) {
    const Result<void> sound = line::check_baud(place.baud);
    if (!sound) return fail(sound);
  }
  if (places.tcp) {
    const Result<line::Listening> listening = line::listen_at(places.tcp->address, places.tcp->port);
    if (!listening) return fail(listening);
    door->listener_ = listening->file;
    door->port_ = listening->port;
    executor.watch_readable(door->listener_, [self = door.get()] { self->accept(); });
  }
  for (const SerialPlace& place : places.serial) door->serial_.push_back(executor.spawn(door->serve_line(place)));
  return door;
}

Door::~Door() {
  if (listener_ < 0) return;
  setup_.executor.unwatch_readable(listener_);
  ::close(listener_);
}

void Door::accept() {
  const int file = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
  if (file < 0) return;
  if (connections_.size() >= most_connections + most_refused) {
    ::close(file);
    return;
  }
  const int on = 1;
  ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  ::setsockopt(file, SOL_SOCKET, SO_SNDBUF, &kernel_buffer, sizeof kernel_buffer);
  const int number = next_connection_++;
  auto& connection = *connections_.emplace(number, std::make_unique<Connection>(setup_.executor, file)).first->second;
  connection.job = setup_.executor.spawn(receive(number, connection.lines));
}

Task<void> Door::receive(int number, Lines& lines) {
  if (connections_.size() > most_connections) {
    lines.say(failure_line("closed", {"too-many", "too many devices are here", {}, {}}));
  } else {
    const Time deadline = setup_.executor.now() + hello_within;
    co_await serve(lines, deadline);
  }
  co_await lines.finish();
  // Not from inside its own job.
  setup_.executor.post([this, number, alive = std::weak_ptr(alive_)] {
    if (!alive.expired()) connections_.erase(number);
  });
}

Task<void> Door::serve_line(SerialPlace place) {
  while (true) {
    const Result<int> file = line::open_serial(place.path, place.baud, line::Parity::none);
    if (!file) {
      say_once(describe(file.error()));
    } else {
      say_once(fmt::format("devices may come over {}", place.path));
      Lines lines(setup_.executor, *file);
      while (!lines.over()) {
        co_await serve(lines, std::nullopt);
      }
    }
    co_await sleep(setup_.executor, look_for_line);
  }
}

Task<void> Door::serve(Lines& lines, std::optional<Time> deadline) {
  const Guest::Admit admitting = [this, &lines](const std::string& name, const std::string& token) {
    return admit(lines, name, token);
  };
  Guest guest(setup_.executor, lines, admitting);
  co_await guest.run(deadline);
  forget(lines);
}

Result<Guest::Admitted> Door::admit(Lines& lines, const std::string& name, const std::string& token) {
  Result<Pass> pass = pass_of(setup_.keys, name, token);
  if (!pass) {
    // The device learns no more than that it is not let in.
    if (pass.error().symbol == "not-permitted") return fail(pass);
    say_once(fmt::format("{} is not let in: {}", name, describe(pass.error())));
    return fail("not-permitted", "the key of this device cannot be used: whoever runs the door is told why");
  }
  Result<std::unique_ptr<Board>> board = setup_.board(*pass);
  if (!board) return fail(board);
  forget(lines);
  Lines*& here = sessions_[name];
  if (here != nullptr) here->interrupt({"replaced", "this device has come again, over another line", {}, {}});
  here = &lines;
  return Guest::Admitted{std::move(*pass), std::move(*board)};
}

void Door::forget(const Lines& lines) {
  std::erase_if(sessions_, [&lines](const auto& session) { return session.second == &lines; });
}

void Door::say_once(const std::string& news) {
  if (news == said_) return;
  said_ = news;
  setup_.news(news);
}

}  // namespace pizarra::door
