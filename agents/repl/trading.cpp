#include "agents/repl/trading.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "lisp/writer.hpp"

namespace pizarra::repl {

namespace {

constexpr std::array comparisons = {">", ">=", "<", "<=", "=", "/="};

bool is_met(const Wish& wish, const Datum& value) {
  if (wish.compare.empty()) return true;
  const bool numbers = value.is_number() && wish.value.is_number();
  // A text is compared with a name as it is spelled: hosts are texts, and typed as names.
  const bool same = numbers ? value.number() == wish.value.number() : value.text() == wish.value.text();
  if (wish.compare == "=") return same;
  if (wish.compare == "/=") return !same;
  if (!numbers) return false;
  const double difference = value.number() - wish.value.number();
  if (wish.compare == ">") return difference > 0;
  if (wish.compare == ">=") return difference >= 0;
  return wish.compare == "<" ? difference < 0 : difference <= 0;
}

}  // namespace

Result<std::vector<Wish>> wishes_from(const Datum& form) {
  std::vector<Wish> wishes;
  for (const Datum& item : form.items().subspan(2)) {
    const bool named = item.size() > 1 && item[0].is_symbol();
    if (named && item.size() == 2 && item[1].is_symbol("?")) {
      wishes.push_back({std::string(item[0].text()), {}, {}});
      continue;
    }
    const bool compared = named && item.size() == 3 && item[1].is_symbol() &&
                          std::ranges::find(comparisons, item[1].text()) != comparisons.end() && !item[2].is_list();
    if (!compared) {
      return fail("malformed", "a condition is (NAME ?) or (NAME OP VALUE), OP one of > >= < <= = /=", item);
    }
    wishes.push_back({std::string(item[0].text()), std::string(item[1].text()), item[2]});
  }
  return wishes;
}

std::optional<std::string> met_by(const std::vector<Wish>& wishes, const std::map<std::string, Datum>& properties) {
  std::string text;
  for (const Wish& wish : wishes) {
    const auto found = properties.find(wish.name);
    if (found == properties.end() || !is_met(wish, found->second)) return std::nullopt;
    const Datum& value = found->second;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", wish.name,
                        value.is_string() ? std::string(value.text()) : write(value));
  }
  return text;
}

}  // namespace pizarra::repl
