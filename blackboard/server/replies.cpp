#include "blackboard/server/replies.hpp"

#include <algorithm>
#include <utility>

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

void KeptReplies::add(wire::RequestId number, HeldReplies::Reply reply) {
  const auto [place, fresh] = replies_.emplace(number, std::move(reply));
  if (fresh) bytes_ += place->second.text.size();
  // One is remembered whatever its size.
  while (replies_.size() > most || (bytes_ > most_bytes && replies_.size() > 1)) {
    forgotten_ = std::max(forgotten_, replies_.begin()->first);
    bytes_ -= replies_.begin()->second.text.size();
    replies_.erase(replies_.begin());
  }
}

const HeldReplies::Reply* KeptReplies::find(wire::RequestId number) const {
  const auto found = replies_.find(number);
  return found == replies_.end() ? nullptr : &found->second;
}

}  // namespace pizarra::server
