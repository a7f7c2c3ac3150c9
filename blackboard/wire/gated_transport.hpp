#pragma once

// A transport whose sockets are deaf and dumb while its gate is closed: of a board that must not answer, because
// another may lead by now.
//
//   GatedTransport gated(zeromq(), [&] { return term.may_answer(uptime(), revision); });
//   BoardServer::open(executor, board, {.transport = &gated});
//
// The gate is asked before each frame that comes or goes. Clients repeat what was dropped. A frame that comes while the
// gate is closed may still be answered; an empty answer is none. It outlives its sockets.

#include <functional>

#include "blackboard/wire/frame_socket.hpp"

namespace pizarra::wire {

class GatedTransport : public Transport {
 public:
  using Gate = std::function<bool()>;
  using WhileClosed = std::function<std::string(const std::string& sender_key, std::string_view frame)>;
  GatedTransport(Transport& inner, Gate gate, WhileClosed while_closed = nullptr)
      : inner_(inner), gate_(std::move(gate)), while_closed_(std::move(while_closed)) {}
  std::unique_ptr<FrameSocket> open(Executor& executor, FrameSocket::Kind kind,
                                    FrameSocket::Receiver receiver) override;

 private:
  Transport& inner_;
  const Gate gate_;
  const WhileClosed while_closed_;
};

}  // namespace pizarra::wire
