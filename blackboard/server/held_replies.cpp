#include "blackboard/server/held_replies.hpp"

#include "lisp/writer.hpp"

namespace pizarra::server {

HeldReplies::HeldReplies(journal::JournalWriter* journal, Send send) : journal_(journal), send_(std::move(send)) {
  if (journal_ != nullptr) journal_->on_progress = [this] { progress(); };
}

HeldReplies::~HeldReplies() {
  if (journal_ != nullptr) journal_->on_progress = nullptr;
}

void HeldReplies::hold(wire::SessionId session, wire::RequestId request, Reply reply) {
  held_.push_back({session, request, std::move(reply)});
  journal_->keep();
}

void HeldReplies::answer_again(wire::SessionId session, wire::RequestId request, const Reply& reply) const {
  if (journal_ == nullptr || reply.after <= journal_->kept()) return send_(session, reply.text);
  if (journal_->stuck()) send_(session, in_doubt(request, reply));
}

void HeldReplies::progress() {
  std::string frame;
  std::size_t in_frame = 0;
  while (!held_.empty() && held_.front().reply.after <= journal_->kept()) {
    const Held held = std::move(held_.front());
    held_.pop_front();
    frame += held.reply.text;
    const Held* next = held_.empty() ? nullptr : &held_.front();
    const bool goes_on = next != nullptr && next->session == held.session && next->reply.after <= journal_->kept() &&
                         frame.size() + next->reply.text.size() <= wire::bytes_together;
    if (goes_on && ++in_frame < wire::most_messages) continue;
    send_(held.session, frame);
    frame.clear();
    in_frame = 0;
  }
  if (!journal_->stuck()) return;
  for (const Held& held : std::exchange(held_, {})) send_(held.session, in_doubt(held.request, held.reply));
}

std::string HeldReplies::in_doubt(wire::RequestId request, const Reply& reply) const {
  if (!reply.stands) return reply.text;
  const Result<Datum> answered = wire::read_frame(reply.text);
  const Datum value = answered ? (*answered)[2][1] : Datum();
  const Failure failure{"not-durable",
                        "it stands on the board, so do not repeat it, but it goes with the board that ends before it "
                        "can be written: " +
                            journal_->failure()->sentence,
                        value,
                        {}};
  return write(list("reply"_sym, request, failure_to_datum(failure)));
}

}  // namespace pizarra::server
