#include "blackboard/stream.hpp"

#include <algorithm>

#include "lisp/reader.hpp"

namespace pizarra {

Relation stream_relation() {
  return relation_from_datum(
             read_one("(relation stream ((name symbol) (kind symbol) (place list)) (key name))").value())
      .value();
}

Datum stream_fact(std::string_view name, std::string_view kind, const Streams& streams) {
  return list("stream"_sym, Datum::symbol(name), Datum::symbol(kind), streams.place());
}

class LocalStreams::Entry : public Streams::Subscription {
 public:
  Entry(LocalStreams& streams, const std::string& stream, Receiver receiver)
      : streams_(streams), receiver_(std::move(receiver)), place_(streams.entries_.emplace(stream, this)) {}
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;
  ~Entry() override { streams_.entries_.erase(place_); }

  const Receiver& receiver() const { return receiver_; }

 private:
  LocalStreams& streams_;
  Receiver receiver_;
  std::multimap<std::string, Entry*>::iterator place_;
};

bool LocalStreams::watched(const std::string& stream) const { return entries_.contains(stream); }

void LocalStreams::publish(const std::string& stream, const StreamFrame& frame) {
  std::vector<Entry*> receivers;
  const auto [begin, end] = entries_.equal_range(stream);
  for (auto entry = begin; entry != end; ++entry) receivers.push_back(entry->second);
  for (Entry* receiver : receivers) {
    // A receiver may end subscriptions, its own among them.
    const auto [first, last] = entries_.equal_range(stream);
    const bool stands = std::any_of(first, last, [&](const auto& entry) { return entry.second == receiver; });
    if (!stands) continue;
    const Receiver receive = receiver->receiver();
    receive(frame);
  }
}

std::unique_ptr<Streams::Subscription> LocalStreams::subscribe(const std::string& stream, Receiver receiver) {
  return std::make_unique<Entry>(*this, stream, std::move(receiver));
}

}  // namespace pizarra
