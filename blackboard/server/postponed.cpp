#include "blackboard/server/postponed.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"

namespace pizarra {

bool Postponed::has_request(wire::RequestId number) const {
  return std::ranges::any_of(messages_, [&](const Message& message) {
    return message.datum.is_form("request") && wire::count_at(message.datum, 2) == number;
  });
}

bool Postponed::add(Message message) {
  const std::size_t bytes = weigh(message.datum).bytes;
  if (messages_.size() >= most || bytes_ + bytes > most_bytes) return false;
  bytes_ += bytes;
  messages_.push_back(std::move(message));
  return true;
}

void Postponed::wait(Message message) {
  ++message.waits;
  bytes_ += weigh(message.datum).bytes;
  messages_.push_front(std::move(message));
}

Postponed::Message Postponed::next() {
  Message next = std::move(messages_.front());
  messages_.pop_front();
  bytes_ -= weigh(next.datum).bytes;
  return next;
}

}  // namespace pizarra
