#include "agents/launcher/readiness.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/declared.hpp"
#include "lisp/reader.hpp"

namespace pizarra::launcher {

namespace {

constexpr Duration agents_timeout = 20s;
// Longer than an agent waits for a controller that starts together with it.
constexpr Duration devices_timeout = 10s;
constexpr Duration teaching_timeout = 120s;
constexpr Duration declared_pause = 100ms;

// The facts that an agent tells once it has come to its device, and until then.
struct Device {
  std::string_view agent;
  std::string_view name;
  std::string_view known;
  std::string_view trouble;
};
constexpr Device devices[] = {
    {"robot", "arm", "(arm-pose robot ? ? ? ? ? ?)", "(arm robot fault ?why)"},
    {"slave", "arm", "(arm-pose slave ? ? ? ? ? ?)", "(arm slave fault ?why)"},
    {"pan-tilt", "unit", "(head ? ? ?)", "(pan-tilt ? ?why)"},
};

std::string reason_of(const std::optional<Failure>& ended) { return ended ? ": " + describe(*ended) : std::string(); }

// Of an agent that lives: what it says of its device.
Task<std::string> trouble_of(Device device, Board& board) {
  const Result<std::vector<Fact>> told = co_await runtime::facts_if_declared(board, read_one(device.trouble).value());
  const bool silent = !told || told->empty() || told->front().datum.items().back().text().empty();
  co_return silent ? std::string() : fmt::format(": {}", told->front().datum.items().back().text());
}

}  // namespace

Task<Result<Answer>> await_when_declared(Board& board, Executor& executor, Query query, Time deadline) {
  while (true) {
    Result<Answer> answer = co_await await_answer(board, query, deadline, executor);
    if (answer || answer.error().symbol != "undeclared-relation") co_return answer;
    if (executor.now() >= deadline) co_return answer;
    co_await sleep(executor, declared_pause);
  }
}

Task<Result<void>> await_agents(LocalCell& cell, Board& board, std::vector<std::string> kinds) {
  const Time deadline = cell.executor().now() + agents_timeout;
  for (const std::string& kind : kinds) {
    Query query = query_for(list("agent"_sym, Datum::symbol(kind), "?"_sym, "?"_sym));
    const Result<Answer> there = co_await await_when_declared(board, cell.executor(), std::move(query), deadline);
    if (there) continue;
    co_return fail("no-agents", fmt::format("the {} agent does not come up{}", kind, reason_of(cell.ended(kind))));
  }
  co_return {};
}

Task<Result<void>> await_devices(LocalCell& cell, Board& board, std::vector<std::string> kinds) {
  const Time deadline = cell.executor().now() + devices_timeout;
  for (const Device& device : devices) {
    if (std::ranges::find(kinds, device.agent) == kinds.end()) continue;
    Query query = query_for(read_one(device.known).value());
    const Result<Answer> there = co_await await_when_declared(board, cell.executor(), std::move(query), deadline);
    if (there) continue;
    const std::string agent(device.agent);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(devices_timeout).count();
    const std::optional<Failure> ended = cell.ended(agent);
    std::string why = reason_of(ended);
    if (!ended) why = co_await trouble_of(device, board);
    const std::string sentence =
        fmt::format("{} has not reached its {} within {} s{}", agent, device.name, seconds, why);
    co_return fail("no-device", sentence, Datum::symbol(agent));
  }
  co_return {};
}

Task<Result<void>> await_teaching(Board& board, Executor& executor) {
  const Time deadline = executor.now() + teaching_timeout;
  const Datum form =
      list("and"_sym, list("person"_sym, "?state"_sym, "?detail"_sym), list("/="_sym, "?state"_sym, "teaching"_sym));
  Query query = query_from_datum(form).value();
  const Result<Answer> end = co_await await_when_declared(board, executor, std::move(query), deadline);
  if (!end) co_return fail("not-taught", "the objects were not learned in time");
  if (end->bindings.find("?state")->is_symbol("done")) co_return {};
  const Failure why = failure_from_datum(*end->bindings.find("?detail"));
  co_return fail("not-taught", why.sentence, why.subject);
}

}  // namespace pizarra::launcher
