#include "drivers/arm/motoman/bsc_station.hpp"
#include "drivers/simulation/controllers/arms/host_control.hpp"
#include "drivers/simulation/controllers/arms/switched_wire.hpp"
#include "drivers/simulation/controllers/serve.hpp"

namespace pizarra::simulation {

namespace {

// What it answers to a message: none to one that is no command.
Task<std::optional<arm::BscMessage>> answer_to(HostControl& control, arm::BscMessage message) {
  if (message.header != arm::bsc::command) co_return std::nullopt;
  std::string& text = message.text;
  while (text.ends_with('\r') || text.ends_with('\n')) text.pop_back();
  const std::size_t blank = std::min(text.find(' '), text.size());
  std::string name = text.substr(0, blank);
  std::string operands = text.substr(blank);
  const HostAnswer answer = co_await control.carry_out(std::move(name), std::move(operands));
  arm::BscMessage reply;
  const bool data = answer.refusal == 0 && !answer.data.empty();
  reply.header = data ? arm::bsc::data : arm::bsc::code;
  reply.text = (data ? answer.data : host_code(answer.refusal)) + "\r";
  co_return reply;
}

}  // namespace

Task<void> serve_bsc(Executor& executor, HostControl& control, line::ByteWire& line) {
  SwitchedWire switched(line, [&control] { return control.powered(); });
  arm::BscStation station(executor, switched, arm::BscStation::Manners::insists);
  bool open = false;
  while (true) {
    const Time deadline = executor.now() + opening_patience;
    if (!open) {
      const Result<void> opened = co_await station.open(deadline);
      open = opened.has_value();
      if (!open) co_await sleep(executor, opening_pause);
      continue;
    }
    Result<arm::BscMessage> message = co_await station.receive(deadline);
    if (!message) {
      open = message.error().symbol != "disconnected";
      continue;
    }
    std::optional<arm::BscMessage> reply = co_await answer_to(control, std::move(*message));
    if (!reply) continue;
    // Who does not want to know is not told.
    [[maybe_unused]] const Result<void> told = co_await station.send(std::move(*reply));
  }
}

}  // namespace pizarra::simulation
