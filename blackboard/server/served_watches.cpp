#include "blackboard/server/served_watches.hpp"

#include <algorithm>
#include <utility>

#include "blackboard/store/indexing.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

const Datum* ServedWatches::asked(wire::WatchId number) const {
  const auto standing = watches_.find(number);
  return standing == watches_.end() ? nullptr : &standing->second.asked;
}

void ServedWatches::add(wire::WatchId number, Datum asked, bool kept, std::unique_ptr<watch::WatchQueue> queue) {
  watches_[number] = {std::move(asked), kept, std::move(queue)};
}

Result<bool> ServedWatches::acknowledge(wire::WatchId number, std::uint64_t sequence) {
  Served& watch = watches_.at(number);
  if (sequence > watch.sent) return fail("bad-frame", "a change that was never sent is acknowledged");
  const bool is_news = sequence > watch.acknowledged;
  if (is_news) watch.acknowledged = sequence;
  return is_news;
}

bool ServedWatches::is_about(wire::WatchId number, std::string_view relation) const {
  return std::ranges::any_of(watches_.at(number).queue->query().clauses, [&](const Query::Clause& clause) {
    return clause.kind == Query::Clause::Kind::fact && clause.form.head() == relation;
  });
}

bool ServedWatches::are_behind() const {
  return std::ranges::any_of(watches_, [](const auto& watch) { return watch.second.queue->ready(); });
}

bool ServedWatches::send(wire::FrameSocket& socket, const std::string& peer, std::size_t& examined) {
  bool more = false;
  for (auto& [number, watch] : watches_) {
    if (blocked_) break;
    more = send(socket, peer, number, watch, examined) || more;
  }
  std::erase_if(watches_, [](const auto& watch) { return watch.second.queue == nullptr; });
  return more && !blocked_;
}

bool ServedWatches::send(wire::FrameSocket& socket, const std::string& peer, wire::WatchId number, Served& watch,
                         std::size_t& examined) {
  const std::size_t width = width_of(watch.queue->query());
  std::uint64_t newest = watch.sent;
  const auto may_send = [&] { return watch.queue->ready() && newest - watch.acknowledged < most_under_way; };
  std::string frame;
  std::string change;
  const auto send_frame = [&] {
    blocked_ = !socket.send(peer, std::exchange(frame, {}));
    // What did not go is not under way: the next change has its number.
    if (blocked_) watch.queue->resynchronise();
    if (!blocked_) watch.sent = newest;
    return !blocked_;
  };
  while (may_send()) {
    const bool may_look = examined < limits::examined_a_turn && !store::Indexing::is_awaiting();
    if (watch.queue->must_look() && !may_look) return true;
    blocked_ = !socket.has_room(peer);
    if (blocked_) return false;
    const Result<std::optional<Delta>> delta = watch.queue->pop_delta(examined);
    if (!delta) {
      blocked_ = !socket.send(peer, write(list("watch-failed"_sym, number, failure_to_datum(delta.error()))));
      if (!blocked_) watch.queue.reset();
      return false;
    }
    if (!*delta) continue;
    change.clear();
    wire::write_change(change, number, newest + 1, width, watch.kept, **delta);
    const bool fits = frame.size() + change.size() <= wire::bytes_together;
    if (!frame.empty() && !fits && !send_frame()) return false;
    frame += change;
    ++newest;
    // Fewer are under way than a frame may hold.
    const bool is_last = !may_send() || watch.queue->must_look() || !socket.has_room(peer);
    if (is_last && !send_frame()) return false;
  }
  return false;
}

void ServedWatches::begin_again() {
  blocked_ = false;
  for (auto& [number, watch] : watches_) {
    watch.acknowledged = watch.sent;
    watch.queue->resynchronise();
  }
}

}  // namespace pizarra::server
