#include "programs/commands/console_instruments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/turns.hpp"
#include "programs/commands/board_sample.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/cell_sight.hpp"
#include "programs/commands/live_traffic.hpp"
#include "programs/method/report.hpp"

namespace pizarra::programs {

namespace {

constexpr Duration first_sample = 100ms;  // long enough for a rate, short enough for who waits for it
constexpr Duration longest_answer = 2s;
constexpr std::size_t most_cells = 200;  // on a page
constexpr std::size_t longest_text_of_cell = 200;

struct Sampling {
  Executor& executor;
  BoardSampler sampler;
  bool begun = false;
};

Task<Result<std::string>> next_sample(std::shared_ptr<Sampling> sampling) {
  if (!sampling->begun) {
    const Result<void> begun = co_await sampling->sampler.begin();
    if (!begun) co_return fail(begun);
    sampling->begun = true;
    co_await sleep(sampling->executor, first_sample);
  }
  const Result<BoardSample> sample = co_await sampling->sampler.next();
  if (!sample) co_return fail(sample);
  co_return json_of(*sample);
}

Task<Result<std::string>> method_of(Executor& executor, Board& board, std::string name,
                                    console::Instruments::Connect connect, Duration length) {
  const auto kinds = method::known_components({});
  if (!kinds) co_return fail(kinds);
  const auto lists = method::known_wrapped();
  if (!lists) co_return fail(lists);
  LiveLook look(executor, board, std::move(name), std::move(connect));
  const Result<method::Traffic> traffic = co_await look.at(length);
  if (!traffic) co_return fail(traffic);
  co_return method::json_of(method::report_on(*traffic, *kinds, *lists));
}

// One page after the other: a look has a session with each of many boards.
Task<Result<std::string>> cells_of(Executor& executor, std::shared_ptr<Turns> turns, std::string address,
                                   std::string secret) {
  const Turns::Turn turn = co_await turns->take();
  const Result<std::optional<wire::ClientKeys>> keys = client::keys_from(secret);
  if (!keys) co_return fail(keys);
  client::Contexts contexts(executor, prompt_name(), *keys, longest_answer);
  std::vector<CellSight> cells = co_await look_at_cells(executor, contexts, std::move(address), most_cells + 1);
  const bool more = cells.size() > most_cells;
  if (more) cells.pop_back();
  std::vector<std::string> texts;
  for (const CellSight& cell : cells) texts.push_back(json_of(cell, longest_text_of_cell));
  co_return fmt::format("{{\"cells\":[{}],\"more\":{}}}", fmt::join(texts, ","), more);
}

Task<Result<Datum>> ask_truth(simulation::Link& link) {
  Datum request = list("truth"_sym);
  Result<simulation::Message> answer = co_await link.call(std::move(request), longest_answer);
  if (!answer) co_return fail(answer);
  co_return std::move(answer->head);
}

}  // namespace

console::Instruments console_instruments(Executor& executor) {
  console::Instruments instruments;
  instruments.activity = [&executor](Board& board, const std::string& name) {
    auto sampling = std::make_shared<Sampling>(executor, BoardSampler(executor, board, name));
    return [sampling] { return next_sample(sampling); };
  };
  instruments.method = [&executor](Board& board, const std::string& name, console::Instruments::Connect connect,
                                   Duration length) {
    return method_of(executor, board, name, std::move(connect), length);
  };
  return instruments;
}

console::Instruments console_instruments(Executor& executor, std::string address,
                                         std::function<std::string(const std::string&)> secret_of) {
  console::Instruments instruments = console_instruments(executor);
  instruments.cells = [&executor, turns = std::make_shared<Turns>(executor), address = std::move(address),
                       secret_of = std::move(secret_of)](const std::string& key) {
    return cells_of(executor, turns, address, secret_of(key));
  };
  return instruments;
}

console::TruthFeed::Ask truth_of_world(simulation::Link& link) {
  return [&link] { return ask_truth(link); };
}

}  // namespace pizarra::programs
