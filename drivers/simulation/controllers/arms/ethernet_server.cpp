#include <fmt/format.h>

#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/frames.hpp"
#include "drivers/simulation/controllers/arms/host_control.hpp"
#include "drivers/simulation/controllers/arms/switched_wire.hpp"
#include "drivers/simulation/controllers/serve.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

namespace {

constexpr Duration silence = 30s;  // that ends a session
constexpr std::string_view start = "CONNECT Robot_access";
constexpr std::string_view keep_alive = "Keep-Alive:";
constexpr std::string_view request_begins = "HOSTCTRL_REQUEST ";
constexpr std::string_view nonsense = "NG: HTTP Error Response\r\n";

// How many commands the line asks for, -1 for any number; none where it is no start.
std::optional<int> commands_asked_for(std::string_view line) {
  constexpr int most = 32767;
  if (!line.starts_with(start)) return std::nullopt;
  line.remove_prefix(start.size());
  while (line.starts_with(' ')) line.remove_prefix(1);
  if (line.empty()) return 1;
  if (!line.starts_with(keep_alive)) return std::nullopt;
  return number_from(trimmed(line.substr(keep_alive.size())), -1, most);
}

struct Request {
  std::string name;
  std::size_t size;  // of its operands, with the CR after them
};

std::optional<Request> request_in(std::string_view line) {
  constexpr int longest = 4096;
  if (!line.starts_with(request_begins)) return std::nullopt;
  line.remove_prefix(request_begins.size());
  const std::size_t blank = line.find(' ');
  if (blank == std::string_view::npos) return std::nullopt;
  const std::optional<int> size = number_from(trimmed(line.substr(blank + 1)), 0, longest);
  if (!size) return std::nullopt;
  return Request{std::string(line.substr(0, blank)), static_cast<std::size_t>(*size)};
}

std::string error(const std::string& name, std::uint16_t code) {
  return fmt::format("ERROR: {} is not successful({}).\r\n", name, host_code(code));
}

class Session {
 public:
  Session(Executor& executor, HostControl& control, line::ByteWire& line)
      : executor_(executor), control_(control), line_(line), lines_(line, line::frame_of_line) {}

  Task<void> run() {
    const Result<std::string> greeting = co_await next();
    if (!greeting) co_return;
    const std::optional<int> commands = commands_asked_for(*greeting);
    if (!commands) co_return say(nonsense);
    say(*commands == 1 ? "OK: NX Information Server(1.30).\r\n"
                       : fmt::format("OK: NX Information Server(1.30) Keep-Alive:{}.\r\n", *commands));
    bool goes_on = true;
    for (int i = 0; goes_on && i != *commands; ++i) {
      goes_on = co_await command();
      if (*commands < 0) i = 0;
    }
  }

 private:
  Task<Result<std::string>> next() {
    const Time deadline = executor_.now() + silence;
    co_return co_await lines_.next(deadline);
  }

  // False where the session is over.
  Task<bool> command() {
    const Result<std::string> line = co_await next();
    if (!line) co_return false;
    const std::optional<Request> asked = request_in(*line);
    if (!asked) {
      say(nonsense);
      co_return false;
    }
    say(fmt::format("OK: {}\r\n", asked->name));
    std::string operands;
    if (asked->size > 0) {
      const Result<std::string> told = co_await next();
      if (!told) co_return false;
      operands = *told;
    }
    HostAnswer answer{.refusal = arm::motoman::wrong_length};
    const bool as_long_as_said = asked->size == (asked->size > 0 ? operands.size() + 1 : 0);
    if (as_long_as_said) answer = co_await control_.carry_out(asked->name, std::move(operands));
    if (answer.refusal != 0) {
      say(error(asked->name, answer.refusal));
    } else {
      say((answer.data.empty() ? "0000" : answer.data) + "\r");
    }
    co_return true;
  }

  void say(std::string_view what) { static_cast<void>(line_.write(what)); }

  Executor& executor_;
  HostControl& control_;
  line::ByteWire& line_;
  line::Frames lines_;
};

}  // namespace

Task<void> serve_ethernet_server(Executor& executor, HostControl& control, line::ByteWire& port) {
  SwitchedWire line(port, [&control] { return control.powered(); });
  while (true) {
    const Time opened_by = executor.now() + opening_patience;
    const Result<void> open = co_await line.open(opened_by);
    if (open) {
      Session session(executor, control, line);
      co_await session.run();
    } else {
      co_await sleep(executor, opening_pause);
    }
    line.close();
  }
}

}  // namespace pizarra::simulation
