#include "lisp/forms/domain_merge.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace pizarra::forms {

namespace {

// What an entry is about: (constant cube) and (rule on) in a perception, else the section and a name.
using Key = std::pair<std::string, std::string>;

std::string symbol_of(const Datum& datum) { return datum.is_symbol() ? std::string(datum.text()) : std::string(); }

std::optional<Key> key_in(std::string kind, std::string name) {
  if (name.empty()) return std::nullopt;
  return Key{std::move(kind), std::move(name)};
}

std::optional<Key> key_of_part(const Datum& part) {
  const std::string kind(part.head());
  if (kind == "sees") return Key{kind, ""};
  if (part.size() < 2) return std::nullopt;
  if (kind == "constant") return key_in(kind, symbol_of(part[1]));
  if (kind == "fact" || kind == "rule") return key_in(kind, std::string(part[1].head()));
  return std::nullopt;
}

// None where the entry is malformed.
std::optional<Key> key_of(std::string_view section, const Datum& entry) {
  if (section == "perception") return key_of_part(entry);
  if (section == "operator") return entry.size() < 2 ? std::nullopt : key_in("operator", symbol_of(entry[1]));
  return key_in(std::string(section), section == "types" ? symbol_of(entry) : std::string(entry.head()));
}

Piece list_at(const Spot& where, std::vector<Piece> pieces) {
  std::vector<Datum> data;
  Piece out{{}, {where.offset, where.last, {}, where.text}};
  for (Piece& piece : pieces) {
    data.push_back(std::move(piece.datum));
    out.spot.items.push_back(std::move(piece.spot));
  }
  out.datum = Datum::list(std::move(data));
  return out;
}

void append(std::vector<Piece>& pieces, std::vector<Piece> more) {
  std::ranges::move(more, std::back_inserter(pieces));
}

// The own entries, each new one waiting for the next that replaces something.
std::vector<Piece> merge_entries(std::string_view section, const std::vector<Piece>& own,
                                 const std::vector<Piece>& other) {
  std::map<Key, std::vector<Piece>> replacing;
  for (const Piece& entry : other) {
    if (const std::optional<Key> key = key_of(section, entry.datum)) replacing.try_emplace(*key);
  }
  std::vector<Piece> waiting;
  for (const Piece& entry : own) {
    waiting.push_back(entry);
    const std::optional<Key> key = key_of(section, entry.datum);
    const auto place = key ? replacing.find(*key) : replacing.end();
    if (place != replacing.end()) append(place->second, std::exchange(waiting, {}));
  }
  std::vector<Piece> merged;
  std::set<Key> replaced;
  for (const Piece& entry : other) {
    const std::optional<Key> key = key_of(section, entry.datum);
    if (key && !replacing[*key].empty()) {
      append(merged, std::exchange(replacing[*key], {}));
      replaced.insert(*key);
    } else if (!key || !replaced.contains(*key)) {
      merged.push_back(entry);
    }
  }
  append(merged, std::move(waiting));
  return merged;
}

// (FACT ...), (del (FACT ...)) or (del FACT ...).
bool is_about(const Datum& effect, const std::set<std::string>& names) {
  if (!effect.is_form("del") || effect.size() < 2) return names.contains(std::string(effect.head()));
  return names.contains(effect[1].is_list() ? std::string(effect[1].head()) : symbol_of(effect[1]));
}

Piece without_effects_on(const Piece& from, const std::set<std::string>& names) {
  std::vector<Piece> parts = pieces_of(from);
  for (Piece& part : parts) {
    if (!part.datum.is_form("effects")) continue;
    std::vector<Piece> effects = pieces_of(part);
    std::erase_if(effects, [&](const Piece& effect) { return is_about(effect.datum, names); });
    part = list_at(part.spot, std::move(effects));
  }
  return list_at(from.spot, std::move(parts));
}

// The entries of a section without those that are left out.
std::vector<Piece> kept(std::string_view section, std::vector<Piece> entries, const std::set<std::string>& left_out) {
  std::erase_if(entries, [&](const Piece& entry) {
    const std::optional<Key> key = key_of(section, entry.datum);
    return key && left_out.contains(key->second);
  });
  if (section != "operator") return entries;
  for (Piece& entry : entries) entry = without_effects_on(entry, left_out);
  return entries;
}

constexpr std::string_view sections_with_entries[] = {"types", "predicates", "objects",
                                                      "facts", "perception", "micro-tasks"};

bool has_entries(const Datum& section) {
  return std::ranges::any_of(sections_with_entries, [&](std::string_view name) { return section.is_form(name); });
}

// A domain's sections by what becomes of them.
struct Sections {
  std::map<std::string, Piece, std::less<>> named;  // the first of each name
  std::vector<Piece> operators;
  std::vector<Piece> others;
};

Sections sections_of(const Piece& domain) {
  Sections out;
  const std::vector<Piece> pieces = pieces_of(domain);
  for (std::size_t i = 2; i < pieces.size(); ++i) {
    const Piece& section = pieces[i];
    if (section.datum.is_form("operator")) {
      out.operators.push_back(section);
    } else if (!has_entries(section.datum) ||
               !out.named.try_emplace(std::string(section.datum.head()), section).second) {
      out.others.push_back(section);
    }
  }
  return out;
}

std::vector<Piece> entries_of(const Piece& section) {
  std::vector<Piece> entries = pieces_of(section);
  entries.erase(entries.begin());
  return entries;
}

}  // namespace

std::vector<Piece> pieces_of(const Piece& list) {
  std::vector<Piece> out;
  for (std::size_t i = 0; i < list.datum.size(); ++i) out.push_back({list.datum[i], list.spot.items[i]});
  return out;
}

Piece merge_domains(const Piece& own, const Piece& other, const std::set<std::string>& left_out) {
  std::vector<Piece> merged = pieces_of(own);
  merged.resize(std::min<std::size_t>(merged.size(), 2));
  const Sections mine = sections_of(own), theirs = sections_of(other);
  for (const std::string_view name : sections_with_entries) {
    const auto in_mine = mine.named.find(name), in_theirs = theirs.named.find(name);
    const bool said = in_mine != mine.named.end(), inherited = in_theirs != theirs.named.end();
    if (!said && !inherited) continue;
    const Piece& section = said ? in_mine->second : in_theirs->second;
    std::vector<Piece> items{pieces_of(section).front()};
    append(items,
           merge_entries(name, said ? entries_of(section) : std::vector<Piece>(),
                         inherited ? kept(name, entries_of(in_theirs->second), left_out) : std::vector<Piece>()));
    merged.push_back(list_at(section.spot, std::move(items)));
  }
  append(merged, merge_entries("operator", mine.operators, kept("operator", theirs.operators, left_out)));
  append(merged, mine.others);
  append(merged, theirs.others);
  return list_at(own.spot, std::move(merged));
}

std::set<std::string> names_said(const Piece& domain) {
  std::set<std::string> names;
  const auto add = [&](std::string_view section, const std::vector<Piece>& entries) {
    for (const Piece& entry : entries) {
      const std::optional<Key> key = key_of(section, entry.datum);
      if (key && !key->second.empty()) names.insert(key->second);
    }
  };
  const Sections said = sections_of(domain);
  for (const auto& [name, section] : said.named) add(name, entries_of(section));
  add("operator", said.operators);
  return names;
}

}  // namespace pizarra::forms
