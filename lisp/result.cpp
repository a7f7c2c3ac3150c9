#include "lisp/result.hpp"

#include "lisp/writer.hpp"

namespace pizarra {

Datum failure_to_datum(const Failure& failure) {
  const std::string_view symbol = is_symbol_name(failure.symbol) ? std::string_view(failure.symbol) : "failed";
  std::vector<Datum> items{"fail"_sym, Datum::symbol(symbol), Datum::string(failure.sentence), failure.subject};
  if (!failure.place.empty()) items.push_back(Datum::string(failure.place));
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

std::string describe(const Failure& failure) {
  std::string out = failure.sentence;
  const std::string subject = failure.subject == Datum() ? std::string() : write(failure.subject);
  const bool said = out.find(subject) != std::string::npos ||
                    (failure.subject.is_string() && out.find(failure.subject.text()) != std::string::npos);
  if (!said) out += ": " + subject;
  if (!failure.place.empty()) out += '\n' + failure.place;
  return out;
}

}  // namespace pizarra
