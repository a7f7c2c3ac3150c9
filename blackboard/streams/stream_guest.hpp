#pragma once

// A subscriber on the publisher's machine: what comes to a StreamDoor.
//
//   auto guest = StreamGuest::come(executor, door_name, "vision-left", receiver, [] { /* the publisher is gone */ });
//
// Either is called last in whatever calls it, and may destroy the guest.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/stream.hpp"
#include "blackboard/streams/file_passing.hpp"
#include "blackboard/streams/shared_ring.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::streams {

class StreamGuest : public Streams::Subscription {
 public:
  using Lost = std::function<void()>;

  // Failure unreachable: nobody is there, on this machine.
  static Result<std::unique_ptr<StreamGuest>> come(Executor& executor, const std::string& door,
                                                   const std::string& stream, Streams::Receiver receiver, Lost lost);
  StreamGuest(const StreamGuest&) = delete;
  StreamGuest& operator=(const StreamGuest&) = delete;
  ~StreamGuest() override;

 private:
  StreamGuest(Executor& executor, File socket, File bells, Streams::Receiver receiver, Lost lost);
  void hear();
  bool take_ring(Packet packet);
  void look();

  Executor& executor_;
  File socket_;
  File bells_;  // an epoll of the bell: it reports every ring once, without a byte being read
  File bell_;
  std::optional<SharedRingView> ring_;
  Streams::Receiver receiver_;
  Lost lost_;
};

}  // namespace pizarra::streams
