#pragma once

// Lets other processes reach a World of this one: the other end of SocketLink.
//
//   World world(executor, config);
//   Result<std::unique_ptr<LinkServer>> server = LinkServer::listen(executor, context, "ipc:///run/cell/world", world);
//   executor.run_until([] { return false; });
//
// At most 64 requests are in hand at once; more are answered `busy`. Messages that are not requests are dropped.
// Destroying it removes the file of an ipc address.

#include <functional>
#include <list>
#include <zmq.hpp>

#include "blackboard/time/executor.hpp"
#include "drivers/simulation/world.hpp"

namespace pizarra::simulation {

// Answers what is asked of devices.
using Devices = std::function<Task<Result<Message>>(Datum request)>;

class LinkServer {
 public:
  // Failure: bad-address.
  static Result<std::unique_ptr<LinkServer>> listen(Executor& executor, zmq::context_t& context,
                                                    const std::string& address, World& world);
  // The same for what else speaks as the devices of a world do.
  static Result<std::unique_ptr<LinkServer>> listen(Executor& executor, zmq::context_t& context,
                                                    const std::string& address, Devices devices);
  ~LinkServer();
  LinkServer(const LinkServer&) = delete;
  LinkServer& operator=(const LinkServer&) = delete;

 private:
  LinkServer(Executor& executor, zmq::socket_t socket, Devices devices);
  void receive();
  void accept(std::string peer, std::uint64_t id, Datum request);
  Task<void> answer(std::string peer, std::uint64_t id, Datum request);
  void reply(const std::string& peer, std::uint64_t id, const Result<Message>& answer);

  Executor& executor_;
  zmq::socket_t socket_;
  Devices devices_;
  std::list<Job> jobs_;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace pizarra::simulation
