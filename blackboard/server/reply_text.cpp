#include "blackboard/server/reply_text.hpp"

#include "lisp/shortened.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

Datum result_to_datum(const Result<Datum>& result) {
  if (result) return list("ok"_sym, *result);
  Failure failure = result.error();
  constexpr std::size_t longest_sentence = 1 << 10;
  constexpr std::size_t heaviest_subject = 1 << 12;
  failure.sentence = shortened(failure.sentence, longest_sentence);
  const bool heavy = weigh(failure.subject).bytes > heaviest_subject;
  if (heavy) failure.subject = failure.subject.items().empty() ? Datum() : failure.subject[0];
  if (weigh(failure.subject).bytes > heaviest_subject) failure.subject = {};
  return failure_to_datum(failure);
}

std::string reply_text(wire::RequestId id, const Datum& result) {
  std::string text = "(reply ";
  write_number_to(text, id);
  write_to(text += ' ', result);
  text += ')';
  return text;
}

}  // namespace pizarra::server
