#pragma once

// A publisher's streams for other hosts: ZeroMQ's PUB/SUB over TCP, encrypted.
//
//   auto broadcast = StreamBroadcast::open(executor, "tcp://10.0.0.7:*");
//   (*broadcast)->ticket();                // (tcp "tcp://10.0.0.7:41233" SERVER-KEY PUBLIC-KEY SECRET-KEY)
//   if ((*broadcast)->watched("vision-left")) (*broadcast)->publish("vision-left", frame);
//   auto listener = StreamListener::come(executor, context, ticket, "vision-left", receiver);
//
// A ticket is what a subscriber needs, its keys among it, made anew by every publisher. It is told on the board: who
// may read there that a stream exists may see the stream, and nobody else can. A subscriber that reads slowly has two
// frames under way, and misses what comes meanwhile.

#include <memory>
#include <set>
#include <string>
#include <zmq.hpp>

#include "blackboard/stream.hpp"
#include "blackboard/streams/socket_pump.hpp"
#include "blackboard/wire/doorkeeper.hpp"
#include "lisp/result.hpp"

namespace pizarra::streams {

class StreamBroadcast {
 public:
  // An address by which others reach this host; its port may be `*`. Failures bad-address, address-in-use.
  static Result<std::unique_ptr<StreamBroadcast>> open(Executor& executor, const std::string& address);

  const Datum& ticket() const { return ticket_; }
  bool watched(const std::string& stream) const;
  void publish(const std::string& stream, const StreamFrame& frame);

 private:
  explicit StreamBroadcast(Executor& executor);
  Result<void> bind(const std::string& address);
  void heard(std::string_view subscription);

  Executor& executor_;
  zmq::context_t context_{1};
  std::string admitted_;  // the public key that the ticket's secret belongs to
  wire::Doorkeeper doorkeeper_;
  zmq::socket_t socket_;
  std::set<std::string, std::less<>> topics_;
  Datum ticket_;
  std::unique_ptr<SocketPump> pump_;
};

class StreamListener : public Streams::Subscription {
 public:
  // The receiver may destroy it. Failure bad-ticket.
  static Result<std::unique_ptr<StreamListener>> come(Executor& executor, zmq::context_t& context, const Datum& ticket,
                                                      const std::string& stream, Streams::Receiver receiver);

 private:
  StreamListener(zmq::socket_t socket, std::string stream, Streams::Receiver receiver);
  void heard(std::string_view text);

  zmq::socket_t socket_;
  const std::string stream_;
  Streams::Receiver receiver_;
  std::unique_ptr<SocketPump> pump_;
};

}  // namespace pizarra::streams
