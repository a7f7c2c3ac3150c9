#include "agents/vision/marks/tag_text.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/outside_text.hpp"

namespace pizarra::vision {
namespace {

std::string_view short_name(std::string_view family) {
  for (const std::string_view maker : {"apriltag-", "aruco-"}) {
    if (family.starts_with(maker)) family.remove_prefix(maker.size());
  }
  return family;
}

std::unexpected<Failure> no_tag(std::string_view text) {
  return fail("bad-tag", fmt::format("{} is no tag: a tag is FAMILY:ID, as 36h11:17, and several are FAMILY:0-11,20",
                                     text_of_bytes(text)));
}

struct Numbered {
  const TagFamily* family;
  std::string_view numbers;
};

Result<Numbered> numbered(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return no_tag(text);
  const Result<const TagFamily*> family = family_from_text(text.substr(0, colon));
  if (!family) return fail(family);
  return Numbered{*family, text.substr(colon + 1)};
}

Result<int> number_of(const TagFamily& family, std::string_view digits, std::string_view text) {
  int out = 0;
  const char* const end = digits.data() + digits.size();
  const auto [read_to, error] = std::from_chars(digits.data(), end, out);
  const bool too_large = error == std::errc::result_out_of_range;
  if ((error != std::errc() && !too_large) || read_to != end || digits.starts_with('-')) return no_tag(text);
  const int tags = tags_of(family);
  if (too_large || out >= tags) {
    return fail("no-such-tag", fmt::format("{} has the tags 0 to {}, and no {}", family.name, tags - 1, digits));
  }
  return out;
}

// FIRST-LAST, or a number alone.
Result<void> add_span(const TagFamily& family, std::string_view span, std::string_view text, std::vector<Tag>& out) {
  const std::size_t dash = span.find('-');
  const bool alone = dash == std::string_view::npos;
  const Result<int> first = number_of(family, span.substr(0, dash), text);
  if (!first) return fail(first);
  const Result<int> last = alone ? first : number_of(family, span.substr(dash + 1), text);
  if (!last) return fail(last);
  if (*last < *first) return no_tag(text);
  for (int number = *first; number <= *last; ++number) {
    const bool is_named = std::ranges::find(out, number, &Tag::number) != out.end();
    if (!is_named) out.push_back({std::string(family.name), number});
  }
  return {};
}

}  // namespace

Result<const TagFamily*> family_from_text(std::string_view text) {
  std::vector<std::string_view> names;
  for (const TagFamily& family : tag_families()) {
    if (text == family.name || text == short_name(family.name)) return &family;
    names.push_back(short_name(family.name));
  }
  return fail("unknown-family",
              fmt::format("there is no family of tags {}; there are {}", text_of_bytes(text), fmt::join(names, ", ")));
}

Result<Tag> tag_from_text(std::string_view text) {
  const Result<Numbered> parts = numbered(text);
  if (!parts) return fail(parts);
  const Result<int> number = number_of(*parts->family, parts->numbers, text);
  if (!number) return fail(number);
  return Tag{std::string(parts->family->name), *number};
}

Result<std::vector<Tag>> tags_from_text(std::string_view text) {
  const Result<Numbered> parts = numbered(text);
  if (!parts) return fail(parts);
  std::vector<Tag> out;
  std::string_view rest = parts->numbers;
  while (true) {
    const std::size_t comma = rest.find(',');
    const Result<void> added = add_span(*parts->family, rest.substr(0, comma), text, out);
    if (!added) return fail(added);
    if (comma == std::string_view::npos) return out;
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace pizarra::vision
