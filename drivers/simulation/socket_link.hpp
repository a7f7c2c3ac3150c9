#pragma once

// The device link to a world in another process, over a ZeroMQ ipc socket on the executor's thread.
//
//   zmq::context_t context(1);
//   SocketLink link(executor, context, "ipc:///run/cell/world");
//
// The world may start later, end and come back: calls meanwhile wait for it and fail with `disconnected` when their
// time is over, later ones work again. At most 64 calls wait at once.

#include <map>
#include <zmq.hpp>

#include "blackboard/time/latch.hpp"
#include "drivers/simulation/link.hpp"

namespace pizarra::simulation {

class SocketLink : public Link {
 public:
  SocketLink(Executor& executor, zmq::context_t& context, const std::string& address);
  // No call may be waiting any more.
  ~SocketLink() override;
  Task<Result<Message>> call(Datum request, Duration timeout) override;

 private:
  static constexpr Duration reconnect_poll = 20ms;
  struct Waiting;
  Result<void> send(std::uint64_t id, const Datum& request);
  void receive();

  Executor& executor_;
  zmq::socket_t socket_;
  std::uint64_t last_id_ = 0;
  std::map<std::uint64_t, Waiting*> waiting_;
};

}  // namespace pizarra::simulation
