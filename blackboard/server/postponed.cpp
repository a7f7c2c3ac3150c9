#include "blackboard/server/postponed.hpp"

#include <optional>

#include "blackboard/limits.hpp"

namespace pizarra::server {

namespace {

std::optional<wire::RequestId> request_of(const Datum& message) {
  return message.is_form("request") ? wire::count_at(message, 2) : std::nullopt;
}

}  // namespace

bool Postponed::add(Message message) {
  const std::size_t bytes = weigh(message.datum).bytes;
  if (messages_.size() >= most || bytes_ + bytes > most_bytes) return false;
  const auto number = request_of(message.datum);
  if (number && requests_.size() >= most_requests) return false;
  bytes_ += bytes;
  if (number) requests_.insert(*number);
  messages_.push_back(std::move(message));
  return true;
}

void Postponed::wait(Message message) {
  bytes_ += weigh(message.datum).bytes;
  if (const auto number = request_of(message.datum)) requests_.insert(*number);
  messages_.push_front(std::move(message));
}

Postponed::Message Postponed::next() {
  Message next = std::move(messages_.front());
  messages_.pop_front();
  ++next.waits;
  bytes_ -= weigh(next.datum).bytes;
  if (const auto number = request_of(next.datum)) requests_.erase(*number);
  return next;
}

}  // namespace pizarra::server
