#include "blackboard/wire/gated_transport.hpp"

#include <utility>

namespace pizarra::wire {

namespace {

class GatedSocket : public FrameSocket {
 public:
  GatedSocket(const GatedTransport::Gate& gate, const GatedTransport::WhileClosed& while_closed, Receiver receiver)
      : gate_(gate), while_closed_(while_closed), receiver_(std::move(receiver)) {}
  void stand_before(std::unique_ptr<FrameSocket> inner) { inner_ = std::move(inner); }
  void receive(const std::string& peer, std::optional<std::string_view> frame) {
    if (gate_()) return receiver_(peer, frame);
    if (!while_closed_ || !frame) return;
    const std::string answer = while_closed_(inner_->sender_key(), *frame);
    if (!answer.empty()) inner_->send(peer, answer);
  }

  Result<std::string> bind(const std::string& address, const KeyPair* own) override {
    return inner_->bind(address, own);
  }
  void admit(Admit admit) override { inner_->admit(std::move(admit)); }
  Result<void> connect(const std::string& address, const ClientKeys* keys, std::optional<Listener> listener) override {
    return inner_->connect(address, keys, std::move(listener));
  }
  void connect_again() override { inner_->connect_again(); }
  void connect_to(const std::string& address) override { inner_->connect_to(address); }
  bool send(const std::string& peer, std::string_view frame) override { return gate_() && inner_->send(peer, frame); }
  bool has_room(const std::string& peer) const override { return gate_() && inner_->has_room(peer); }
  const std::string& sender_key() const override { return inner_->sender_key(); }
  Time heard_until() override { return inner_->heard_until(); }

 private:
  const GatedTransport::Gate& gate_;
  const GatedTransport::WhileClosed& while_closed_;
  const Receiver receiver_;
  std::unique_ptr<FrameSocket> inner_;
};

}  // namespace

std::unique_ptr<FrameSocket> GatedTransport::open(Executor& executor, FrameSocket::Kind kind,
                                                  FrameSocket::Receiver receiver) {
  auto gated = std::make_unique<GatedSocket>(gate_, while_closed_, std::move(receiver));
  gated->stand_before(inner_.open(
      executor, kind, [socket = gated.get()](const std::string& peer, std::optional<std::string_view> frame) {
        socket->receive(peer, frame);
      }));
  return gated;
}

}  // namespace pizarra::wire
