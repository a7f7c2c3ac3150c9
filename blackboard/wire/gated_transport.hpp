#pragma once

// A transport whose sockets are deaf and dumb while its gate is closed: of a board that must not answer, because
// another may lead by now.
//
//   GatedTransport gated(zeromq(), [&] { return term.may_answer(executor.now(), revision); });
//   BoardServer::open(executor, board, {.transport = &gated});
//
// The gate is asked before each frame that comes or goes. What is dropped is asked for again by clients. It outlives
// its sockets.

#include <functional>

#include "blackboard/wire/frame_socket.hpp"

namespace pizarra::wire {

class GatedTransport : public Transport {
 public:
  using Gate = std::function<bool()>;
  GatedTransport(Transport& inner, Gate gate) : inner_(inner), gate_(std::move(gate)) {}
  std::unique_ptr<FrameSocket> open(Executor& executor, FrameSocket::Kind kind,
                                    FrameSocket::Receiver receiver) override;

 private:
  Transport& inner_;
  const Gate gate_;
};

}  // namespace pizarra::wire
