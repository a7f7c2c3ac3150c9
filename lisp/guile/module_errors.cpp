#include "lisp/guile/module_errors.hpp"

#include <algorithm>

namespace pizarra::guile {

namespace {

std::vector<std::size_t> path_of(const Datum& error) {
  std::vector<std::size_t> path;
  for (const Datum& index : error[2].items()) path.push_back(static_cast<std::size_t>(index.integer()));
  return path;
}

Failure locate(const Source& source, const Datum& error) {
  std::vector<std::string> context;
  for (const Datum& line : error[3].items()) context.emplace_back(line.text());
  return source.failure_at(path_of(error), std::string(error[0].text()), std::string(error[1].text()), context);
}

// The element that a path leads to; () where there is none.
Datum element_at(std::span<const Datum> elements, const std::vector<std::size_t>& path) {
  Datum element;
  for (const std::size_t index : path) {
    if (index >= elements.size()) return {};
    element = elements[index];
    elements = element.items();
  }
  return element;
}

// Behind the name or number that begins there; of a list, behind its parenthesis.
std::size_t end_of_atom(const Source& source, std::size_t offset) {
  return std::max(offset + 1, std::min(source.text().find_first_of(" \t\r\n();\"", offset), source.text().size()));
}

}  // namespace

bool is_module_error(const Datum& error) {
  return error.size() == 4 && error[0].is_symbol() && error[1].is_string() && error[2].is_list() && error[3].is_list();
}

// A place that could not be read gets no second error.
std::vector<Failure> failures_of(const Source& source, std::span<const Datum> errors) {
  std::vector<Failure> failures;
  auto unread = source.errors().begin();
  for (const Datum& error : errors) {
    const std::size_t offset = source.offset_at(path_of(error));
    for (; unread != source.errors().end() && unread->offset < offset; ++unread) {
      failures.push_back(source.failure_of(*unread));
    }
    const bool said = unread != source.errors().end() && unread->offset < end_of_atom(source, offset);
    if (!said) failures.push_back(locate(source, error));
  }
  for (; unread != source.errors().end(); ++unread) failures.push_back(source.failure_of(*unread));
  return failures;
}

Failure failure_of(std::span<const Datum> data, const Datum& error) {
  return {std::string(error[0].text()), std::string(error[1].text()), element_at(data, path_of(error)), {}};
}

}  // namespace pizarra::guile
