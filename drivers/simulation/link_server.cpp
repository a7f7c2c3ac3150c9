#include "drivers/simulation/link_server.hpp"

#include <unistd.h>

#include "drivers/simulation/link_address.hpp"
#include "drivers/simulation/link_wire.hpp"

namespace pizarra::simulation {

Result<std::unique_ptr<LinkServer>> LinkServer::listen(Executor& executor, zmq::context_t& context,
                                                       const std::string& address, World& world) {
  return listen(executor, context, address, [&world](Datum request) { return world.handle(std::move(request)); });
}

Result<std::unique_ptr<LinkServer>> LinkServer::listen(Executor& executor, zmq::context_t& context,
                                                       const std::string& address, Devices devices) {
  zmq::socket_t socket(context, zmq::socket_type::router);
  link_wire::limit(socket);
  try {
    socket.bind(address);
  } catch (const zmq::error_t& error) {
    return fail("bad-address", std::string("nobody can listen there: ") + error.what(), Datum::string(address));
  }
  return std::unique_ptr<LinkServer>(new LinkServer(executor, std::move(socket), std::move(devices)));
}

LinkServer::LinkServer(Executor& executor, zmq::socket_t socket, Devices devices)
    : executor_(executor), socket_(std::move(socket)), devices_(std::move(devices)) {
  executor_.watch_readable(socket_.get(zmq::sockopt::fd), [this] { receive(); });
}

LinkServer::~LinkServer() {
  executor_.unwatch_readable(socket_.get(zmq::sockopt::fd));
  // ZeroMQ leaves an ipc address's file behind. One that is gone already is fine.
  const std::string bound = socket_.get(zmq::sockopt::last_endpoint);
  if (is_link_address(bound)) unlink(bound.c_str() + link_scheme.size());
}

void LinkServer::receive() {
  jobs_.remove_if([](const Job& job) { return job.done(); });
  while (auto parts = link_wire::receive_parts(socket_)) {
    if (parts->size() != 2) continue;
    const Result<link_wire::Call> call = link_wire::read_call((*parts)[1].to_string_view());
    if (call) accept((*parts)[0].to_string(), call->id, call->request);
  }
}

void LinkServer::accept(std::string peer, std::uint64_t id, Datum request) {
  if (jobs_.size() < link_wire::most_calls) {
    jobs_.push_back(executor_.spawn(answer(std::move(peer), id, std::move(request))));
    return;
  }
  reply(peer, id, fail("busy", "too many requests wait for the simulated devices"));
}

Task<void> LinkServer::answer(std::string peer, std::uint64_t id, Datum request) {
  const Result<Message> answered = co_await devices_(std::move(request));
  reply(peer, id, answered);
}

void LinkServer::reply(const std::string& peer, std::uint64_t id, const Result<Message>& answered) {
  link_wire::Parts parts = link_wire::answer_parts({id, answered});
  // A peer that is gone, or reads too slowly, loses its answer and runs into its timeout.
  if (!socket_.send(zmq::buffer(peer), zmq::send_flags::dontwait | zmq::send_flags::sndmore)) return;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool more = i + 1 < parts.size();
    const auto flags = more ? zmq::send_flags::dontwait | zmq::send_flags::sndmore : zmq::send_flags::dontwait;
    if (!socket_.send(parts[i], flags)) return;
  }
  // Sending may swallow the descriptor's one signal that something has arrived.
  executor_.post([this, alive = std::weak_ptr(alive_)] {
    if (alive.lock()) receive();
  });
}

}  // namespace pizarra::simulation
