#include "drivers/simulation/head_wire.hpp"

namespace pizarra::simulation {

namespace {

constexpr Duration head_time = 2s;

}  // namespace

Task<Result<void>> HeadWire::open(Time) {
  unsent_.clear();
  open_ = true;
  const Result<std::string> forgotten = co_await exchange();
  open_ = forgotten.has_value();
  if (!forgotten) co_return fail(forgotten);
  co_return Result<void>();
}

// Bytes go with the next reading, which follows every command.
Result<void> HeadWire::write(std::string_view bytes) {
  if (!open_) return fail("disconnected", "the line is closed");
  if (unsent_.size() + bytes.size() > most_unsent) return fail("disconnected", "the line takes no more");
  unsent_ += bytes;
  return {};
}

Task<Result<std::string>> HeadWire::exchange() {
  if (!unsent_.empty()) {
    const Datum said = list("head"_sym, "send"_sym, std::exchange(unsent_, {}));
    const Result<Message> sent = co_await link_.call(said, head_time);
    if (!sent) co_return fail("disconnected", sent.error().sentence);
  }
  const Datum listen = list("head"_sym, "hear"_sym);
  const Result<Message> heard = co_await link_.call(listen, head_time);
  if (!heard) co_return fail("disconnected", heard.error().sentence);
  if (heard->head.size() != 1) co_return fail("disconnected", "the world answered nonsense", heard->head);
  co_return std::string(heard->head[0].text());
}

Task<Result<std::string>> HeadWire::read(Time deadline) {
  while (open_) {
    const Result<std::string> heard = co_await exchange();
    if (!heard) co_return fail(heard);
    if (!heard->empty()) co_return *heard;
    if (executor_.now() >= deadline) co_return fail("timeout", "nothing came over the line in time");
  }
  co_return fail("disconnected", "the line is closed");
}

}  // namespace pizarra::simulation
