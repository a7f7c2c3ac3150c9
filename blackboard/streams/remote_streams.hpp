#pragma once

// The streams' wall between processes and hosts. Frames reach subscribers of the publisher's machine through memory
// that both share (StreamDoor), others over the network (StreamBroadcast); which, the subscriber finds out by trying.
//
//   auto streams = RemoteStreams::open(executor, board);                      // of this machine alone, or
//   auto streams = RemoteStreams::open(executor, board, "tcp://10.0.0.7:*");  // for other hosts too
//   board.tell(stream_fact("vision-left", "left", **streams));
//   auto eyes = (*streams)->subscribe("vision-left", [](const StreamFrame& frame) { ... });
//
// A subscription follows the stream's fact: it begins when the stream is announced, and goes on with the next publisher
// under that name when one is gone. While the board is away it goes on as it is. The board outlives the streams, and
// these their subscriptions.

#include <memory>
#include <string>
#include <zmq.hpp>

#include "blackboard/board.hpp"
#include "blackboard/stream.hpp"
#include "blackboard/streams/stream_broadcast.hpp"
#include "blackboard/streams/stream_door.hpp"

namespace pizarra::streams {

class RemoteStreams : public Streams {
 public:
  // Failures no-socket, bad-address, address-in-use.
  static Result<std::unique_ptr<RemoteStreams>> open(Executor& executor, Board& board,
                                                     const std::string& listen_address = "");

  Datum place() const override;
  bool watched(const std::string& stream) const override;
  void publish(const std::string& stream, const StreamFrame& frame) override;
  std::unique_ptr<Subscription> subscribe(const std::string& stream, Receiver receiver) override;

 private:
  class Following;
  RemoteStreams(Executor& executor, Board& board, std::unique_ptr<StreamDoor> door,
                std::unique_ptr<StreamBroadcast> broadcast);

  Executor& executor_;
  Board& board_;
  zmq::context_t context_{1};
  std::unique_ptr<StreamDoor> door_;
  std::unique_ptr<StreamBroadcast> broadcast_;
};

}  // namespace pizarra::streams
