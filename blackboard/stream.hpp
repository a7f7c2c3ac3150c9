#pragma once

// Images travel beside the board: a stream is announced in a fact (stream NAME KIND PLACE), its frames go from
// publisher to subscribers, and the newest wins: who reads slowly sees fewer frames and disturbs nobody. Like boards,
// streams have walls: in this process (LocalStreams), and between processes (streams/remote_streams.hpp).
//
//   transaction.tell(stream_fact("vision-left", "left", streams), {}, presence);
//   if (streams.watched("vision-left")) streams.publish("vision-left", frame);
//   auto eyes = streams.subscribe("vision-left", [](const StreamFrame& frame) { ... });

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "blackboard/relation.hpp"
#include "blackboard/time/clock.hpp"

namespace pizarra {

// Pixels row by row, interleaved: 1 channel grey, 3 channels BGR.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;
  std::vector<std::uint8_t> pixels;
};

struct StreamFrame {
  std::uint64_t number = 0;
  Time captured{};
  std::shared_ptr<const Image> image;
};

class Streams {
 public:
  using Receiver = std::function<void(const StreamFrame&)>;
  // Destroying it ends the subscription.
  class Subscription {
   public:
    virtual ~Subscription() = default;
    // Why it does not follow its stream just now, such as not-permitted.
    virtual std::optional<Failure> trouble() const { return std::nullopt; }
  };

  virtual ~Streams() = default;
  // Where subscribers elsewhere find what is published here, as a list; () where nobody can.
  virtual Datum place() const = 0;
  virtual bool watched(const std::string& stream) const = 0;
  virtual void publish(const std::string& stream, const StreamFrame& frame) = 0;
  virtual std::unique_ptr<Subscription> subscribe(const std::string& stream, Receiver receiver) = 0;
};

// What a stream is announced with: (relation stream ((name symbol) (kind symbol) (place list)) (key name)).
Relation stream_relation();
Datum stream_fact(std::string_view name, std::string_view kind, const Streams& streams);

// Streams within one process; receivers are called from publish(). It outlives its subscriptions.
class LocalStreams : public Streams {
 public:
  Datum place() const override { return {}; }
  bool watched(const std::string& stream) const override;
  void publish(const std::string& stream, const StreamFrame& frame) override;
  std::unique_ptr<Subscription> subscribe(const std::string& stream, Receiver receiver) override;

 private:
  class Entry;
  std::multimap<std::string, Entry*> entries_;
};

}  // namespace pizarra
