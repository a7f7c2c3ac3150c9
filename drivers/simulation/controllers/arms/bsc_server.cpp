#include "drivers/arm/motoman/bsc_station.hpp"
#include "drivers/simulation/controllers/arms/host_control.hpp"
#include "drivers/simulation/controllers/arms/switched_wire.hpp"

namespace pizarra {

namespace {

constexpr Duration patience = 3600s;
constexpr Duration retry_pause = 100ms;

// What it answers to a message: none to one that is no command.
Task<std::optional<BscMessage>> answer_to(HostControl& control, BscMessage message) {
  if (message.header != bsc::command) co_return std::nullopt;
  std::string& text = message.text;
  while (text.ends_with('\r') || text.ends_with('\n')) text.pop_back();
  const std::size_t blank = std::min(text.find(' '), text.size());
  std::string name = text.substr(0, blank);
  std::string operands = text.substr(blank);
  const HostAnswer answer = co_await control.carry_out(std::move(name), std::move(operands));
  BscMessage reply;
  const bool data = answer.refusal == 0 && !answer.data.empty();
  reply.header = data ? bsc::data : bsc::code;
  reply.text = (data ? answer.data : host_code(answer.refusal)) + "\r";
  co_return reply;
}

}  // namespace

Task<void> serve_bsc(Executor& executor, HostControl& control, ByteWire& line) {
  SwitchedWire switched(line, [&control] { return control.powered(); });
  BscStation station(executor, switched, BscStation::Manners::insists);
  bool open = false;
  while (true) {
    const Time deadline = executor.now() + patience;
    if (!open) {
      const Result<void> opened = co_await station.open(deadline);
      open = opened.has_value();
      if (!open) co_await sleep(executor, retry_pause);
      continue;
    }
    Result<BscMessage> message = co_await station.receive(deadline);
    if (!message) {
      open = message.error().symbol != "disconnected";
      continue;
    }
    std::optional<BscMessage> reply = co_await answer_to(control, std::move(*message));
    if (!reply) continue;
    // Who does not want to know is not told.
    [[maybe_unused]] const Result<void> told = co_await station.send(std::move(*reply));
  }
}

}  // namespace pizarra
