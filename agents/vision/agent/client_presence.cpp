#include "agents/vision/agent/client_presence.hpp"

#include <algorithm>

namespace pizarra::vision {
namespace {

Datum presence_of(Datum who) { return list("agent"_sym, std::move(who), "?"_sym, "?"_sym); }

}  // namespace

Task<Result<bool>> ClientPresence::is_present(std::string client) {
  const Datum pattern = presence_of(Datum::symbol(client));
  const Result<std::vector<Fact>> present = co_await context_.board.facts(pattern);
  if (!present) co_return fail(present);
  co_return !present->empty();
}

Task<std::string> ClientPresence::holder_for(std::string client) {
  const Result<bool> present = co_await is_present(client);
  if (present.value_or(false)) co_return client;
  absent_until_ = context_.executor.now() + ModeHolders::absent_for;
  co_return std::string(ModeHolders::absent);
}

Task<bool> ClientPresence::let_dead_go(ModeHolders& holders) {
  const bool lapsed = context_.executor.now() >= absent_until_;
  bool let_go = lapsed && holders.let_go(std::string(ModeHolders::absent));
  const std::vector<std::string> clients = holders.clients();
  if (clients.empty()) co_return let_go;
  const Datum anyone = presence_of("?"_sym);
  const Result<std::vector<Fact>> present = co_await context_.board.facts(anyone);
  if (!present) co_return let_go;
  std::set<std::string> now_missing;
  for (const std::string& client : clients) {
    const bool here = std::ranges::any_of(*present, [&](const Fact& fact) { return fact.datum[1].text() == client; });
    if (here) continue;
    if (missing_.contains(client)) {
      let_go |= holders.let_go(client);
    } else {
      now_missing.insert(client);
    }
  }
  missing_ = std::move(now_missing);
  co_return let_go;
}

}  // namespace pizarra::vision
