#pragma once

// Where subscribers of this machine come for a publisher's streams: a Unix socket without a file (an abstract name that
// cannot be guessed). A subscriber says which stream it wants. It receives the stream's shared memory and its bell: an
// eventfd that the publisher writes to once a frame, and that wakes every subscriber.
//
//   Result<std::unique_ptr<StreamDoor>> door = StreamDoor::open(executor);
//   (*door)->name();                                  // what a StreamGuest comes to
//   if ((*door)->watched("vision-left")) (*door)->publish("vision-left", frame);
//
// A subscriber is gone when its end of the socket is closed, as the kernel does when it dies. Nothing is ever waited
// for: a stalled subscriber costs nothing. Subscribers are processes of the same user.

#include <map>
#include <memory>
#include <string>

#include "blackboard/stream.hpp"
#include "blackboard/streams/shared_ring.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::streams {

class StreamDoor {
 public:
  static constexpr std::size_t max_guests = 256;

  // Failure no-socket.
  static Result<std::unique_ptr<StreamDoor>> open(Executor& executor);
  StreamDoor(const StreamDoor&) = delete;
  StreamDoor& operator=(const StreamDoor&) = delete;
  ~StreamDoor();

  const std::string& name() const { return name_; }
  bool watched(const std::string& stream) const { return offers_.contains(stream); }
  void publish(const std::string& stream, const StreamFrame& frame);

 private:
  struct Guest {
    File socket;
    std::string stream;  // empty: it has not said yet
    std::uint64_t ring = 0;
  };
  // A stream while somebody watches it.
  struct Offer {
    std::optional<SharedRing> ring;
    std::uint64_t ring_number = 0;
    File bell;
  };

  StreamDoor(Executor& executor, File socket, std::string name);
  void admit();
  void hear(int guest);
  void dismiss(int guest);
  bool make_room(Offer& offer, std::size_t image_bytes);

  Executor& executor_;
  File socket_;
  const std::string name_;
  std::map<int, Guest> guests_;
  std::map<std::string, Offer> offers_;
  std::uint64_t rings_made_ = 0;
};

}  // namespace pizarra::streams
