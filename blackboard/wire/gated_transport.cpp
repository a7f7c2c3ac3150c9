#include "blackboard/wire/gated_transport.hpp"

#include <utility>

namespace pizarra::wire {

namespace {

class GatedSocket : public FrameSocket {
 public:
  GatedSocket(std::unique_ptr<FrameSocket> inner, const GatedTransport::Gate& gate)
      : inner_(std::move(inner)), gate_(gate) {}

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
  const std::unique_ptr<FrameSocket> inner_;
  const GatedTransport::Gate& gate_;
};

}  // namespace

std::unique_ptr<FrameSocket> GatedTransport::open(Executor& executor, FrameSocket::Kind kind,
                                                  FrameSocket::Receiver receiver) {
  auto gated = [this, receiver = std::move(receiver)](const std::string& peer, std::optional<std::string_view> frame) {
    if (gate_()) receiver(peer, frame);
  };
  return std::make_unique<GatedSocket>(inner_.open(executor, kind, std::move(gated)), gate_);
}

}  // namespace pizarra::wire
