#include "drivers/arm/motoman/bsc_line.hpp"

#include <fmt/format.h>

#include "drivers/line/printable.hpp"

namespace pizarra::arm {

Task<Result<void>> BscLine::open(Time deadline) {
  const Turns::Turn turn = co_await turns_.take();
  Result<void> open = co_await station_.open(deadline);
  co_return open;
}

Task<Result<std::string>> BscLine::command(HostCommand command) {
  Result<std::string> answer = co_await take_turn(command);
  const bool again = !answer && answer.error().symbol == "no-answer" && command.kind != HostCommand::Kind::motion;
  if (!again) co_return answer;
  answer = co_await take_turn(command);
  co_return answer;
}

Task<Result<std::string>> BscLine::take_turn(const HostCommand& command) {
  const bool stops = command.kind == HostCommand::Kind::stop;
  std::optional<Held> waiting;
  if (stops) waiting.emplace(stop_waits_);
  const Turns::Turn turn = co_await turns_.take();
  waiting.reset();
  Result<std::string> answer = co_await exchange(command);
  co_return answer;
}

// Until a stop waits: what is answered later is answered to nobody.
Task<Result<BscMessage>> BscLine::reply() {
  const Time deadline = executor_.now() + reply_time;
  while (true) {
    const Time soon = executor_.now() + look_for_stop;
    Result<BscMessage> reply = co_await station_.receive(soon);
    const bool none_yet = !reply && reply.error().symbol == "timeout";
    if (!none_yet || stop_waits_ || soon >= deadline) co_return reply;
  }
}

Task<Result<std::string>> BscLine::exchange(const HostCommand& command) {
  BscMessage message{std::string(bsc::command), command.name};
  if (!command.operands.empty()) message.text += " " + command.operands;
  message.text += "\r";
  const Result<void> sent = co_await station_.send(std::move(message));
  if (!sent) co_return fail(sent.error().symbol, device_ + ": " + sent.error().sentence);
  const Result<BscMessage> reply = co_await this->reply();
  if (!reply) co_return fail("no-answer", device_ + " did not answer: " + reply.error().sentence);
  std::string_view text = reply->text;
  while (text.ends_with('\r') || text.ends_with('\n')) text.remove_suffix(1);
  const bool question = command.kind == HostCommand::Kind::question;
  if (question && reply->header == bsc::data) co_return std::string(text);
  const bool code = reply->header == bsc::code && is_host_code(text);
  if (code && text != "0000") co_return refused_command(command.name, text);
  if (code && !question) co_return std::string();
  co_return fail("bad-reply", fmt::format("{} answered {} with {} '{}'", device_, command.name,
                                          line::printable(reply->header), line::printable(text)));
}

}  // namespace pizarra::arm
