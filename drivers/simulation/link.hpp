#pragma once

// The private device link between drivers and the simulated world: a call with a Datum, answered by a Datum and images.
// world.hpp lists the requests. Board and agents never see it.
//
//   LocalLink link(world);                                    // the world in this process
//   SocketLink link(executor, context, "ipc:///run/cell/world");  // the world in another (socket_link.hpp)
//   Result<Message> answer = co_await link.call(request, 2s);

#include <memory>
#include <vector>

#include "blackboard/stream.hpp"
#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

struct Message {
  Datum head;  // a list of values
  std::vector<std::shared_ptr<const Image>> images = {};
};

class Link {
 public:
  virtual ~Link() = default;
  // Failures: the world's own, and `disconnected` when it is away or did not answer within `timeout`.
  virtual Task<Result<Message>> call(Datum request, Duration timeout) = 0;
};

// Where there is no world.
class NoLink : public Link {
 public:
  Task<Result<Message>> call(Datum request, Duration timeout) override;
};

class World;

class LocalLink : public Link {
 public:
  explicit LocalLink(World& world) : world_(world) {}
  Task<Result<Message>> call(Datum request, Duration timeout) override;

 private:
  World& world_;
};

}  // namespace pizarra::simulation
