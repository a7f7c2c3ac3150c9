#include "blackboard/server/admission.hpp"

#include <algorithm>

#include "blackboard/teller.hpp"

namespace pizarra::server {

Admission::Admission(memory::MemoryBoard& board, Sessions& sessions, Refusals& refusals, Outbox& outbox,
                     wire::FrameSocket& socket, std::optional<KeyFolder> keys, wire::SessionId life)
    : board_(board),
      sessions_(sessions),
      refusals_(refusals),
      outbox_(outbox),
      socket_(socket),
      keys_(std::move(keys)),
      life_(life) {
  if (keys_) ask_for_keys();
}

void Admission::ask_for_keys() {
  socket_.admit([this](const std::string& public_key) {
    if (keys_->follow()) end_those_of_changed_keys();
    const bool known = keys_->find(public_key) != nullptr;
    if (!known) refusals_.note(public_key, {"not-permitted", "this key is not authorised", {}, {}});
    return known;
  });
}

void Admission::refuse(const std::string& peer, const Failure& failure) {
  refusals_.note(who_is(peer), failure);
  outbox_.send(peer, list("refused"_sym, failure_to_datum(failure)));
}

std::string Admission::who_is(const std::string& peer) const {
  if (const auto session = sessions_.of_peer(peer)) return sessions_.all().at(*session).client();
  const wire::PublicKey* key = keys_ ? keys_->find(socket_.sender_key()) : nullptr;
  return key == nullptr ? socket_.sender_key() : key->name;
}

void Admission::greet(const std::string& peer, const Datum& hello, Time now) {
  const std::optional<std::uint64_t> protocol = hello.size() == 3 ? 1 : wire::count_at(hello, 3);
  const bool formed = hello.size() >= 3 && protocol && hello[1].is_string() && wire::count_at(hello, 2);
  if (!formed) return refuse(peer, {"bad-frame", "a hello is (hello TELLER SESSION PROTOCOL)", {}, {}});
  const Result<void> understood = wire::check_protocol(*protocol);
  if (!understood) return refuse(peer, understood.error());
  const Result<void> named = check_teller_name(hello[1].text());
  if (!named) return refuse(peer, named.error());
  if (keys_ && keys_->follow()) end_those_of_changed_keys();
  const wire::PublicKey* key = nullptr;
  if (!socket_.sender_key().empty()) {
    key = keys_->find(socket_.sender_key());
    if (key == nullptr) return refuse(peer, {"not-permitted", "this key is not authorised any more", {}, {}});
  }
  const std::string teller(hello[1].text());
  const Result<void> permitted = check_hello(peer, teller, key);
  if (!permitted) return refuse(peer, permitted.error());
  const Result<Sessions::Begun> begun = sessions_.begin(peer, teller, *wire::count_from(hello[2]), key);
  if (!begun) return refuse(peer, begun.error());
  sessions_.find(begun->id)->heard = now;
  if (begun->moved) outbox_.schedule(begun->id);
  outbox_.send(peer, list("welcome"_sym, begun->id, life_));
}

Result<void> Admission::check_hello(const std::string& peer, const std::string& teller,
                                    const wire::PublicKey* key) const {
  if (teller == wire::board_key_name) return fail("not-permitted", "nobody else is called board", to_datum(teller));
  if (key != nullptr && !wire::may_call_itself(key->name, teller)) {
    return fail("not-permitted",
                "the teller of the key " + key->name + " is called " + key->name + ", or " + key->name + "/ANYTHING",
                to_datum(teller));
  }
  const std::optional<wire::SessionId> standing = sessions_.of_peer(peer);
  if (!standing || sessions_.all().at(*standing).teller == teller) return {};
  return fail("not-permitted", "this connection is that of " + sessions_.all().at(*standing).teller, to_datum(teller));
}

void Admission::end(wire::SessionId id) {
  const std::string teller = sessions_.find(id)->teller;
  if (sessions_.end(id)) board_.statistics().left(teller);
}

// Who still has a key says hello again.
void Admission::end_those_of_changed_keys() {
  for (const Failure& fault : keys_->faults()) refusals_.note("", fault);
  std::vector<wire::SessionId> ended;
  for (const auto& [id, session] : sessions_.all()) {
    if (!session.key || session.peer.empty()) continue;
    const wire::PublicKey* now = keys_->find(session.key->key);
    if (now == nullptr || *now != *session.key) ended.push_back(id);
  }
  for (const wire::SessionId id : ended) {
    outbox_.send(sessions_.find(id)->peer, list("unknown-session"_sym, id));
    end(id);
  }
}

void Admission::end_silent(Time heard) {
  std::vector<wire::SessionId> gone;
  for (const auto& [id, session] : sessions_.all()) {
    if (session.heard <= heard) gone.push_back(id);
  }
  for (const wire::SessionId id : gone) end(id);
  if (keys_ && keys_->refresh()) end_those_of_changed_keys();
}

}  // namespace pizarra::server
