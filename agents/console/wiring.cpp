#include "agents/console/wiring.hpp"

#include "blackboard/client/contexts.hpp"

namespace pizarra::console {

namespace {

runtime::Contract contract_of_console() {
  constexpr std::string_view contract = R"((contract console
  (posts (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role))
         (relation console-address ((client symbol) (address string)) (key client)))
  (reads agent bound wired)))";
  return runtime::contract_from_text(contract).value();
}

}  // namespace

Wiring::Wiring(Executor& executor, std::unique_ptr<Board> board, std::string address)
    : board_(std::move(board)),
      context_{client, "localhost", executor, *board_, Random(1)},
      service_(context_, contract_of_console()),
      roles_(context_, service_, {runtime::robot_role(), runtime::eyes_role(), runtime::coordinator_role()}),
      telling_(executor.spawn(tell(std::move(address)))) {}

Task<void> Wiring::tell(std::string address) {
  // Pages follow it, and look again for relations that nobody had declared when an agent comes.
  const std::vector<Relation> followed(1, client::Contexts::context_relation());
  [[maybe_unused]] const Result<void> declared = co_await board_->declare(followed);
  const Result<void> present = co_await service_.start();
  if (!present) co_return;
  roles_.start();
  if (address.empty()) co_return;
  Transaction telling;
  telling.tell(list("console-address"_sym, Datum::symbol(client), address), {}, service_.presence());
  // Where this console's key may not tell it, a hall's page has no link to this console.
  [[maybe_unused]] const Result<Revision> told = co_await board_->transact(std::move(telling));
}

Task<void> Wiring::leave() {
  telling_ = Job();
  if (service_.presence() == 0) co_return;
  [[maybe_unused]] const Result<void> left = co_await service_.leave(0s);
}

}  // namespace pizarra::console
