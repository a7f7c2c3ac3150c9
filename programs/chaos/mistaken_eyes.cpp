#include "programs/chaos/mistaken_eyes.hpp"

#include <algorithm>

namespace pizarra::chaos {

namespace {

std::string_view called(std::string_view name, const ExchangedNames& names) {
  if (name == names.one) return names.other;
  return name == names.other ? std::string_view(names.one) : name;
}

// Of a reply (TRACK N ("a" OK (x, y, d)) ("b" FAIL) ...): each name stands behind `("`.
std::string called_in_text(std::string_view text, const ExchangedNames& names) {
  constexpr std::string_view before = "(\"";
  std::string out;
  while (true) {
    const std::size_t name = text.find(before);
    if (name == std::string_view::npos) return out.append(text);
    out += text.substr(0, name + before.size());
    text.remove_prefix(name + before.size());
    const std::size_t end = std::min(text.find('"'), text.size());
    out += called(text.substr(0, end), names);
    text.remove_prefix(end);
  }
}

Datum called_in_look(const Datum& look, const ExchangedNames& names) {
  std::vector<Datum> seen;
  for (const Datum& entry : look[4].items()) {
    std::vector<Datum> parts(entry.items().begin(), entry.items().end());
    if (!parts.empty()) parts[0] = Datum::string(called(parts[0].text(), names));
    seen.push_back(Datum::list(std::move(parts)));
  }
  const std::string text = called_in_text(look[3].text(), names);
  return list(look[0], look[1], look[2], text, Datum::list(std::move(seen)));
}

}  // namespace

Task<Result<Revision>> MistakenEyes::transact(Transaction transaction) {
  if (time_.now() < names_.until) {
    for (Transaction::Step& step : transaction.steps) {
      auto* tell = std::get_if<Transaction::Tell>(&step);
      if (tell != nullptr && tell->fact.is_form("look")) tell->fact = called_in_look(tell->fact, names_);
    }
  }
  return board_.transact(std::move(transaction));
}

}  // namespace pizarra::chaos
