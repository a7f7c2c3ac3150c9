#include "lisp/result.hpp"

#include <algorithm>

#include "lisp/outside_text.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

Datum failure_to_datum(const Failure& failure) {
  const std::string_view symbol = is_symbol_name(failure.symbol) ? std::string_view(failure.symbol) : "failed";
  std::vector<Datum> items{"fail"_sym, Datum::symbol(symbol), Datum::string(lines_of_bytes(failure.sentence)),
                           failure.subject};
  if (!failure.place.empty()) items.push_back(Datum::string(lines_of_bytes(failure.place)));
  return Datum::list(std::move(items));
}

Failure failure_from_datum(const Datum& datum) {
  const bool shaped = datum.is_form("fail") && (datum.size() == 4 || datum.size() == 5) && datum[1].is_symbol() &&
                      datum[2].is_string() && (datum.size() == 4 || datum[4].is_string());
  if (!shaped) return {"malformed-failure", "a failure came in a form that is not one", datum, {}};
  Failure out{std::string(datum[1].text()), std::string(datum[2].text()), datum[3], {}};
  if (datum.size() == 5) out.place = datum[4].text();
  return out;
}

namespace {

// Whether the sentence shows it already, as a whole or, a list of lists, one by one.
bool says(const std::string& sentence, const Datum& subject) {
  if (sentence.find(write(subject)) != std::string::npos) return true;
  if (subject.is_string()) return sentence.find(subject.text()) != std::string::npos;
  if (!subject.is_list() || subject.size() == 0) return false;
  return std::ranges::all_of(subject.items(),
                             [&](const Datum& item) { return item.is_list() && says(sentence, item); });
}

// A whole file may be the subject; its beginning is enough for people, and a few words where its place is shown.
std::string beginning(std::string text, std::size_t longest) {
  return text.size() <= longest ? text : text.substr(0, text.rfind(' ', longest)) + " ...";
}

}  // namespace

std::string describe(const Failure& failure) {
  std::string out = lines_of_bytes(failure.sentence);
  if (failure.subject != Datum() && !says(out, failure.subject))
    out += ": " + beginning(write(failure.subject), failure.place.empty() ? 200 : 30);
  if (!failure.place.empty()) out += '\n' + failure.place;
  return lines_of_bytes(out);
}

}  // namespace pizarra
