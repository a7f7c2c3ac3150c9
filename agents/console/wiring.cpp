#include "agents/console/wiring.hpp"

namespace pizarra::console {

namespace {

runtime::Contract contract_of_console() {
  constexpr std::string_view contract = R"((contract console
  (posts (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role)))
  (reads agent bound wired)))";
  return runtime::contract_from_text(contract).value();
}

}  // namespace

Wiring::Wiring(Executor& executor, std::unique_ptr<Board> board)
    : board_(std::move(board)),
      context_{client, "localhost", executor, *board_, Random(1)},
      service_(context_, contract_of_console()),
      caller_(context_, service_),
      roles_(context_, service_, caller_, {runtime::robot_role(), runtime::eyes_role(), runtime::coordinator_role()}),
      telling_(executor.spawn(tell())) {}

Task<void> Wiring::tell() {
  const Result<void> present = co_await service_.start();
  if (present) roles_.start();
}

Task<void> Wiring::leave() {
  telling_ = Job();
  if (service_.presence() == 0) co_return;
  [[maybe_unused]] const Result<void> left = co_await service_.leave(0s);
}

}  // namespace pizarra::console
