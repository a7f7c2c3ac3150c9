#include "agents/console/page_board.hpp"

#include <fmt/format.h>

#include "agents/console/console_contract.hpp"

namespace pizarra::console {

namespace {

constexpr Duration longest_answer = 120s;

runtime::Contract contract_of_pages() {
  return runtime::contract_from_text(fmt::format("(contract console {} {})", posts_of_pages, reads_of_pages)).value();
}

}  // namespace

PageBoard::PageBoard(Executor& executor, std::string name, std::unique_ptr<Board> board)
    : board_(std::move(board)),
      context_{std::move(name), "localhost", executor, *board_, Random(1)},
      service_(context_, contract_of_pages()),
      caller_(context_, service_) {}

Task<Result<void>> PageBoard::start() { return service_.start(); }

Task<void> PageBoard::leave() {
  if (service_.presence() == 0) co_return;
  [[maybe_unused]] const Result<void> left = co_await service_.leave(0s);
}

Task<Result<Datum>> PageBoard::call(std::string agent, Datum operation) {
  const Datum presence = list("agent"_sym, Datum::symbol(agent), "?"_sym, "?"_sym);
  const Result<std::vector<Fact>> present = co_await board_->facts(presence);
  const bool there = present && !present->empty();
  if (!there) co_return fail("absent", fmt::format("no agent {} is present", agent));
  Result<Datum> answer = co_await caller_.call(agent, operation, longest_answer);
  co_return answer;
}

}  // namespace pizarra::console
