#include "agents/console/page_rights.hpp"

#include <fmt/format.h>
#include <optional>
#include <string_view>

#include "blackboard/boards_own.hpp"
#include "blackboard/wire/keys.hpp"

namespace pizarra::console {

namespace {

// A deed of a person by a word of the page. The page's own session tells and reads these relations for it.
struct Needs {
  std::string_view word;
  std::string_view deed;
  std::vector<std::string_view> tell;
  std::vector<std::string_view> read = {};
};

// Whoever asks an agent withdraws the request, and takes the reply away.
const std::vector<Needs>& needs_of_words() {
  static const std::vector<Needs> needs = {
      {"request", "ask an agent to do anything", {"request", "reply"}, {"agent", "reply"}},
      {"goal", "give goals", {"request", "reply"}, {"agent", "reply"}},
      {"stop", "stop the arm", {"stop"}},
      {"clear-stops", "clear a stop", {"stop", "commander"}},
      {"command", "take the arm in hand", {"commander"}},
      {"take-over", "take the arm over", {"commander"}},
      {"let-go", "let the arm go", {"commander"}},
      {"ask-for", "ask another for the arm", {"commander-wanted"}},
      {"ask-no-more", "ask another for the arm", {"commander-wanted"}},
      {"jog", "move the arm", {"hold", "request", "reply"}, {"agent", "reply"}}};
  return needs;
}

std::optional<std::string_view> first_not_in(const std::vector<std::string>& listed,
                                             const std::vector<std::string_view>& needed) {
  for (const std::string_view relation : needed) {
    if (!wire::permits(listed, relation)) return relation;
  }
  return std::nullopt;
}

}  // namespace

std::map<std::string, std::string> PageRights::refused() const {
  std::map<std::string, std::string> refused;
  const auto refuse = [&](const Needs& needs, std::string_view verb, std::optional<std::string_view> relation) {
    if (!relation) return;
    refused.emplace(needs.word, fmt::format("your key may not {} (it lacks: {} {})", needs.deed, verb, *relation));
  };
  for (const Needs& needs : needs_of_words()) {
    refuse(needs, "tell", first_not_in(tell_, needs.tell));
    refuse(needs, "read", first_not_in(read_, needs.read));
  }
  return refused;
}

Task<PageRights> rights_of(Board& board) {
  const Datum pattern = list(Datum::symbol(own_permission), "?verb"_sym, "?relation"_sym);
  const Result<std::vector<Fact>> listed = co_await board.facts(pattern);
  if (!listed) co_return PageRights({"*"}, {"*"});
  std::vector<std::string> tell;
  std::vector<std::string> read;
  for (const Fact& fact : *listed) {
    if (fact.datum[1].is_symbol("tell")) tell.emplace_back(fact.datum[2].text());
    if (fact.datum[1].is_symbol("read")) read.emplace_back(fact.datum[2].text());
  }
  co_return PageRights(std::move(tell), std::move(read));
}

}  // namespace pizarra::console
