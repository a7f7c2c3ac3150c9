#pragma once

// One end of the line between a board and its clients: frames come by callback, and sending never blocks. A Transport
// carries them: ZeroMQ (wire_socket.hpp), or a simulated network (blackboard/simulated/network.hpp).
//
//   const std::unique_ptr<FrameSocket> router = transport.open(executor, FrameSocket::Kind::router,
//       [&](const std::string& peer, std::optional<std::string_view> frame) { ... });
//   Result<std::string> at = router->bind("tcp://127.0.0.1:*", nullptr);   // the address that it got
//   if (!router->send(peer, text)) ...                                     // it reads too slowly, or is gone
//
// A router answers those who come; a dealer comes to one of them.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra::wire {

struct ClientKeys;
struct KeyPair;

class FrameSocket {
 public:
  enum class Kind : std::uint8_t { router, dealer };
  // `peer` is the sender, at a router; it is empty at a dealer. No frame: something came that is no frame.
  using Receiver = std::function<void(const std::string& peer, std::optional<std::string_view> frame)>;
  // Whether a client with this public key may come.
  using Admit = std::function<bool(const std::string& public_key)>;
  // What a dealer hears of its connection. Failures: not-permitted (the board refuses this key, wants a key, or wants
  // none), unreachable (it is broken off again and again).
  struct Listener {
    std::function<void()> let_in;
    std::function<void(const Failure&)> refused;
  };

  virtual ~FrameSocket() = default;

  // Failure address-in-use, or bad-address. With `own` keys, whoever comes there must have a key that admit() lets in.
  virtual Result<std::string> bind(const std::string& address, const KeyPair* own) = 0;
  // Of a router, before it is bound with keys.
  virtual void admit(Admit admit) = 0;
  virtual Result<void> connect(const std::string& address, const ClientKeys* keys,
                               std::optional<Listener> listener) = 0;
  // After a refusal: connects again, which happens only when this is called.
  virtual void connect_again() = 0;
  // Of a dealer that is connected: leaves the one it comes to for another, with the same keys.
  virtual void connect_to(const std::string& address) = 0;
  // False, and nothing sent, when more than the bound would be under way to the peer, or it is gone.
  virtual bool send(const std::string& peer, std::string_view frame) = 0;
  // Whether half of that bound is free. Frames that can wait leave the other half to those that cannot.
  virtual bool has_room(const std::string& peer) const = 0;
  // The public key of who sent what is being received; empty for one without.
  virtual const std::string& sender_key() const = 0;
  // Up to when everything that had come was received. Where more comes than can be received, each connection had its
  // turn by then. A later call answers a later time.
  virtual Time heard_until() = 0;
};

class Transport {
 public:
  virtual ~Transport() = default;
  // The executor outlives what is opened.
  virtual std::unique_ptr<FrameSocket> open(Executor& executor, FrameSocket::Kind kind,
                                            FrameSocket::Receiver receiver) = 0;
};

// The one that is shipped.
Transport& zeromq();

}  // namespace pizarra::wire
