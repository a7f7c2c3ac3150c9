#include "drivers/arm/motoman/ethernet_line.hpp"

#include <fmt/format.h>

#include "drivers/line/printable.hpp"

namespace pizarra::arm {

namespace {

constexpr std::string_view greeting = "CONNECT Robot_access Keep-Alive:-1\r\n";

bool all_is_well(std::string_view line) { return line.starts_with("OK"); }

// The digits between the brackets of "ERROR: MOVL is not successful(2070)."; empty where there are none.
std::string_view code_in(std::string_view line) {
  const std::size_t open = line.rfind('(');
  if (open == std::string_view::npos) return {};
  const std::string_view code = line.substr(open + 1, line.find(')', open) - open - 1);
  return is_host_code(code) ? code : std::string_view();
}

}  // namespace

std::unexpected<Failure> EthernetLine::unreached(const char* symbol, const Failure& why) const {
  return fail(symbol, fmt::format("{} is not reached: {}", device_, why.sentence));
}

std::unexpected<Failure> EthernetLine::unanswered(const char* symbol, const Failure& why) const {
  return fail(symbol, fmt::format("{} did not answer: {}", device_, why.sentence));
}

std::unexpected<Failure> EthernetLine::strange(const HostCommand& command, std::string_view answer) const {
  return fail("bad-reply", fmt::format("{} answered {} with '{}'", device_, command.name, line::printable(answer)));
}

Task<Result<void>> EthernetLine::open(Time deadline) {
  const Turns::Turn turn = co_await turns_.take();
  Result<void> begun = co_await begin_session(deadline);
  co_return begun;
}

Task<Result<void>> EthernetLine::begin_session(Time deadline) {
  session_ = false;
  const Result<void> open = co_await wire_.open(deadline);
  if (!open) co_return fail("disconnected", open.error().sentence);
  lines_.clear();
  const Result<void> sent = wire_.write(greeting);
  if (!sent) co_return unreached("disconnected", sent.error());
  const Result<std::string> answer = co_await lines_.next(deadline);
  if (!answer) co_return fail("disconnected", device_ + " does not greet: " + answer.error().sentence);
  if (!all_is_well(*answer)) {
    co_return fail("disconnected", fmt::format("{} refuses the connection: {}", device_, line::printable(*answer)));
  }
  session_ = true;
  co_return Result<void>();
}

Task<Result<std::string>> EthernetLine::command(HostCommand command) {
  const Time deadline = executor_.now() + patience;
  while (true) {
    Result<std::string> answer = co_await take_turn(command);
    if (answer) co_return answer;
    const std::string& symbol = answer.error().symbol;
    const bool once = command.kind == HostCommand::Kind::motion;
    const bool again = symbol == "disconnected" || (symbol == "no-answer" && !once);
    if (!again || executor_.now() + pause + answer_time > deadline) co_return answer;
    co_await sleep(executor_, pause);
  }
}

// A stop that comes meanwhile is next.
Task<Result<std::string>> EthernetLine::take_turn(const HostCommand& command) {
  const Turns::Turn turn = co_await turns_.take();
  Result<std::string> answer = co_await exchange(command);
  co_return answer;
}

Task<Result<std::string>> EthernetLine::exchange(const HostCommand& command) {
  if (!session_) {
    const Time deadline = executor_.now() + answer_time;
    const Result<void> begun = co_await begin_session(deadline);
    if (!begun) co_return fail(begun);
  }
  session_ = false;
  const std::string data = command.operands.empty() ? "" : command.operands + "\r";
  const Result<void> asked = wire_.write(fmt::format("HOSTCTRL_REQUEST {} {}\r\n", command.name, data.size()));
  if (!asked) co_return unreached("disconnected", asked.error());
  const Time deadline = executor_.now() + answer_time;
  const Result<std::string> accepted = co_await lines_.next(deadline);
  if (!accepted) co_return unanswered("disconnected", accepted.error());
  if (!all_is_well(*accepted)) {
    const std::string_view code = code_in(*accepted);
    if (!code.empty()) co_return refused_command(command.name, code);
    co_return strange(command, *accepted);
  }
  if (!data.empty()) {
    const Result<void> sent = wire_.write(data);
    if (!sent) co_return unreached("no-answer", sent.error());
  }
  Result<std::string> answer = co_await said(command);
  session_ = answer || answer.error().symbol == "refused";
  co_return answer;
}

// What comes of a command that was begun.
Task<Result<std::string>> EthernetLine::said(const HostCommand& command) {
  const Time deadline = executor_.now() + answer_time;
  Result<std::string> line = co_await lines_.next(deadline);
  if (!line) co_return unanswered("no-answer", line.error());
  const bool error = line->starts_with("ERROR") || line->starts_with("NG");
  const bool question = command.kind == HostCommand::Kind::question;
  if (question && !error) co_return line;
  if (*line == "0000") co_return std::string();
  const std::string_view code = is_host_code(*line) ? std::string_view(*line) : code_in(*line);
  if (!code.empty()) co_return refused_command(command.name, code);
  co_return strange(command, *line);
}

}  // namespace pizarra::arm
