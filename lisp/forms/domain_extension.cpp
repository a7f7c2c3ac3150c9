#include "lisp/forms/domain_extension.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/forms/domain_merge.hpp"
#include "lisp/forms/file_paths.hpp"
#include "lisp/nearest.hpp"

namespace pizarra::forms {

namespace {

constexpr std::size_t most_files = 8;

// The files from the first domain to the one in hand, each extending the next.
using Chain = std::vector<std::filesystem::path>;

using Path = std::vector<std::size_t>;

// Where the sections of that name stand in the source's domain.
std::vector<Path> find_sections(const Source& source, std::string_view name) {
  std::vector<Path> found;
  if (source.data().empty() || !source.data().front().is_form("domain")) return found;
  const Datum& domain = source.data().front();
  for (std::size_t i = 2; i < domain.size(); ++i) {
    if (domain[i].is_form(name)) found.push_back({0, i});
  }
  return found;
}

std::filesystem::path resolved(const std::string& file) {
  std::error_code unknown;
  const std::filesystem::path path = std::filesystem::weakly_canonical(file, unknown);
  return unknown ? std::filesystem::path(file) : path;
}

// The file that the section at `where` names, read; `chain` gets it.
Result<Source> read_extended(const Source& source, const Path& where, Chain& chain) {
  const Datum& section = source.data()[0][where[1]];
  const auto refuse = [&](std::string symbol, std::string sentence) {
    return fail(source.failure_at(where, std::move(symbol), std::move(sentence)));
  };
  if (section.size() != 2 || !section[1].is_string() || section[1].text().empty()) {
    return refuse("malformed", "this is written (extends \"FILE\")");
  }
  const std::string file = beside(source.file(), std::string(section[1].text()));
  const std::filesystem::path path = resolved(file);
  const auto before = std::ranges::find(chain, path);
  if (before != chain.end()) {
    std::vector<std::string> circle;
    for (auto at = before; at != chain.end(); ++at) circle.push_back(at->filename().string());
    circle.push_back(path.filename().string());
    return refuse("extends-itself", fmt::format("a domain cannot extend itself: {}", fmt::join(circle, " extends ")));
  }
  if (chain.size() == most_files) {
    return refuse("too-many", fmt::format("at most {} files may extend one another", most_files));
  }
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) {
    return refuse("unreadable-file", fmt::format("there is no file {}", file));
  }
  chain.push_back(path);
  Result<Source> other = read_source_file(file);
  if (!other && other.error().place.empty()) return refuse(other.error().symbol, other.error().sentence);
  if (other && (other->data().empty() || !other->data().front().is_form("domain"))) {
    return fail(other->failure_at({0}, "wrong-file", "only a form (domain ...) can be extended"));
  }
  return other;
}

Piece first_of(const Source& source) { return {source.data().front(), source.spots().front()}; }

// The names in the sections (without NAME ...), each one that `known` has.
Result<std::set<std::string>> names_left_out(const Source& source, const std::set<std::string>& known) {
  std::set<std::string> names;
  std::vector<Failure> wrong;
  for (const Path& where : find_sections(source, "without")) {
    const Datum& section = source.data()[0][where[1]];
    for (std::size_t i = 1; i < section.size(); ++i) {
      const Path place{where[0], where[1], i};
      const std::string name(section[i].is_symbol() ? section[i].text() : "");
      if (name.empty()) {
        wrong.push_back(source.failure_at(place, "malformed", "a name must stand here"));
      } else if (!known.contains(name)) {
        const std::string nearest = nearest_name(name, known);
        wrong.push_back(source.failure_at(place, "unknown-name",
                                          fmt::format("the domain that is extended says nothing of {}{}", name,
                                                      nearest.empty() ? "" : "; the nearest is " + nearest)));
      }
      names.insert(name);
    }
  }
  if (!wrong.empty()) return fail(one_report(wrong));
  return names;
}

void raise_text(Spot& spot, std::size_t by) {
  spot.text += by;
  for (Spot& item : spot.items) raise_text(item, by);
}

Piece without_sections(const Piece& domain, std::initializer_list<std::string_view> names) {
  Piece out{{}, domain.spot};
  out.spot.items.clear();
  std::vector<Datum> data;
  for (const Piece& piece : pieces_of(domain)) {
    if (std::ranges::any_of(names, [&](std::string_view name) { return piece.datum.is_form(name); })) continue;
    data.push_back(piece.datum);
    out.spot.items.push_back(piece.spot);
  }
  out.datum = Datum::list(std::move(data));
  return out;
}

Result<Source> extended(Source source, Chain& chain) {
  const std::vector<Path> extends = find_sections(source, "extends");
  if (extends.size() > 1) {
    return fail(source.failure_at(extends[1], "repeated", "a domain extends one other; the other may extend a third"));
  }
  if (extends.empty()) {
    const std::vector<Path> without = find_sections(source, "without");
    if (without.empty()) return source;
    return fail(source.failure_at(without[0], "malformed", "(without ...) needs (extends ...)"));
  }
  Result<Source> read = read_extended(source, extends[0], chain);
  if (!read) return fail(read);
  const Result<Source> other = extended(std::move(*read), chain);
  if (!other) return fail(other);
  Piece theirs = first_of(*other);
  const Result<std::set<std::string>> left_out = names_left_out(source, names_said(theirs));
  if (!left_out) return fail(left_out);
  raise_text(theirs.spot, source.text_count());
  Piece merged = merge_domains(without_sections(first_of(source), {"extends", "without"}), theirs, *left_out);
  source.replace_first(merged.datum, std::move(merged.spot), *other);
  return source;
}

}  // namespace

bool extends_another(const Source& source) { return !find_sections(source, "extends").empty(); }

Result<Source> extended_domain(Source source) {
  Chain chain{resolved(source.file())};
  return extended(std::move(source), chain);
}

}  // namespace pizarra::forms
