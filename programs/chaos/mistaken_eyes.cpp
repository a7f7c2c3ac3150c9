#include "programs/chaos/mistaken_eyes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "lisp/numbers.hpp"

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

const Datum* entry_of(const Datum& objects, std::string_view name) {
  const auto is_its = [&](const Datum& entry) { return entry.size() > 1 && entry[0].text() == name; };
  const auto found = std::ranges::find_if(objects.items(), is_its);
  return found == objects.items().end() ? nullptr : &*found;
}

bool is_seen(const Datum& entry) { return entry[1].is_symbol("seen"); }

// The first part of an entry of this name and so many items.
const Datum* part_of(const Datum& entry, std::string_view name, std::size_t size) {
  const auto is_it = [&](const Datum& part) { return part.is_form(name) && part.size() == size; };
  const auto found = std::ranges::find_if(entry.items(), is_it);
  return found == entry.items().end() ? nullptr : &*found;
}

Datum moved(const Datum& place, double aside_px) {
  return list(place[0], rounded(place[1].number() + aside_px, 100), place[2]);
}

// What was seen of another, so many pixels aside. Of its pose, which would lie elsewhere too, nothing is said.
Datum beside(const Datum& entry, const std::string& name, double aside_px) {
  std::vector<Datum> parts{Datum::string(name)};
  for (const Datum& part : entry.items().subspan(1)) {
    if (part.is_form("pose") || part.is_form("flipped")) continue;
    const bool is_place = part.is_form("left") || part.is_form("right");
    parts.push_back(is_place ? moved(part, aside_px) : part);
  }
  return Datum::list(std::move(parts));
}

// The look with the invented sighting; nothing where it shows the object anyway, or not what that should stand beside.
std::optional<Datum> with_invented(const Datum& look, const InventedSighting& invented) {
  const Datum* unseen = entry_of(look[4], invented.object);
  const Datum* seen = entry_of(look[4], invented.beside);
  if (unseen == nullptr || seen == nullptr || is_seen(*unseen) || !is_seen(*seen)) return std::nullopt;
  const Datum* left = part_of(*seen, "left", 3);
  const Datum* range = part_of(*seen, "range", 3);
  if (left == nullptr || range == nullptr) return std::nullopt;
  std::string text(look[3].text());
  const std::string told = fmt::format("(\"{}\" FAIL)", invented.object);
  const std::size_t at = text.find(told);
  if (at == std::string::npos) return std::nullopt;
  text.replace(at, told.size(),
               fmt::format("(\"{}\" OK ({:.2f}, {:.2f}, {:.2f}))", invented.object,
                           (*left)[1].number() + invented.aside_px, (*left)[2].number(), (*range)[1].number()));
  std::vector<Datum> entries;
  for (const Datum& entry : look[4].items()) {
    entries.push_back(&entry == unseen ? beside(*seen, invented.object, invented.aside_px) : entry);
  }
  return list(look[0], look[1], look[2], text, Datum::list(std::move(entries)));
}

}  // namespace

Task<Result<Revision>> MistakenEyes::transact(Transaction transaction) {
  for (Transaction::Step& step : transaction.steps) {
    auto* tell = std::get_if<Transaction::Tell>(&step);
    if (tell != nullptr && tell->fact.is_form("look")) mistake(tell->fact);
  }
  return board_.transact(std::move(transaction));
}

void MistakenEyes::mistake(Datum& look) {
  if (time_.now() < mistakes_.names.until) look = called_in_look(look, mistakes_.names);
  InventedSighting& invented = mistakes_.invented;
  if (invented.looks_left == 0) return;
  const std::optional<Datum> mistaken = with_invented(look, invented);
  if (!mistaken) return;
  look = *mistaken;
  --invented.looks_left;
}

}  // namespace pizarra::chaos
