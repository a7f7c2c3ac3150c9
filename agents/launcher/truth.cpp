#include "agents/launcher/truth.hpp"

#include <algorithm>
#include <cctype>

namespace pizarra {

namespace {

constexpr Duration link_timeout = 5s;

std::string small(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

}  // namespace

Datum in_small_letters(const Datum& fact) {
  if (fact.is_symbol() || fact.is_string()) return Datum::symbol(small(fact.text()));
  if (!fact.is_list()) return fact;
  std::vector<Datum> items;
  for (const Datum& item : fact.items()) items.push_back(in_small_letters(item));
  return Datum::list(std::move(items));
}

Result<Truth> truth_from_datum(const Datum& head) {
  Truth truth;
  for (const Datum& item : head.items()) {
    if (item.is_form("cube") && item.size() == 9) {
      const bool loose = item[7].is_symbol("loose") || item[7].is_symbol("carried");
      Truth::Cube cube{item[2].number(), item[3].number(), item[4].number(), item[7].is_symbol("gone"), loose,
                       item[8].number()};
      truth.cubes.emplace(small(item[1].text()), cube);
    } else if (item.is_form("facts")) {
      for (const Datum& fact : item.items().subspan(1)) truth.facts.push_back(in_small_letters(fact));
    } else {
      return fail("malformed", "the world's truth has an unknown part", item);
    }
  }
  std::ranges::sort(truth.facts);
  return truth;
}

Task<Result<Truth>> read_truth(Link& link) {
  Datum request = list("truth"_sym);
  const Result<Message> answer = co_await link.call(std::move(request), link_timeout);
  if (!answer) co_return fail(answer);
  co_return truth_from_datum(answer->head);
}

}  // namespace pizarra
