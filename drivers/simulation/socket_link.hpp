#pragma once

// The device link to a world in another process, over a ZeroMQ ipc socket on the executor's thread.
//
//   zmq::context_t context(1);
//   SocketLink link(executor, context, "ipc:///run/cell/world");
//
// The world may start later, end and come back: calls meanwhile wait for it and fail with `disconnected` when their
// time is over, later ones work again. At most 64 calls wait at once.

#include <zmq.hpp>

#include "drivers/simulation/open_calls.hpp"

namespace pizarra::simulation {

class SocketLink : public Link {
 public:
  SocketLink(Executor& executor, zmq::context_t& context, const std::string& address);
  // No call may be waiting any more.
  ~SocketLink() override;
  Task<Result<Message>> call(Datum request, Duration timeout) override;

 private:
  static constexpr Duration reconnect_poll = 20ms;
  Result<void> send(std::uint64_t id, const Datum& request);
  void receive();

  Executor& executor_;
  OpenCalls calls_;
  zmq::socket_t socket_;
};

}  // namespace pizarra::simulation
