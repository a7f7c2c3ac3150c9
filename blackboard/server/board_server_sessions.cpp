// Who a BoardServer's clients are: how a session begins, moves to another connection and ends.

#include <algorithm>
#include <stdexcept>
#include <sys/random.h>

#include "blackboard/server/board_server.hpp"
#include "blackboard/teller.hpp"

namespace pizarra::server {

// Fits a datum, and nobody guesses it.
std::uint64_t BoardServer::random_number() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) throw std::runtime_error("no random numbers to be had");
  return number >> 2 | 1;
}

void BoardServer::ask_for_keys() {
  doorkeeper_.emplace(executor_, socket_.context(), [this](const std::string& public_key) {
    if (keys_->follow()) end_sessions_of_changed_keys();
    const bool known = keys_->find(public_key) != nullptr;
    if (!known) refusals_.note(public_key, {"not-permitted", "this key is not authorised", {}, {}});
    return known;
  });
}

void BoardServer::refuse(const std::string& peer, const Failure& failure) {
  refusals_.note(who_is(peer), failure);
  send(peer, list("refused"_sym, failure_to_datum(failure)));
}

// Of what is being received: its session's client, else its key's name, else nothing.
std::string BoardServer::who_is(const std::string& peer) const {
  if (const auto found = session_of_peer_.find(peer); found != session_of_peer_.end()) {
    return client_of(sessions_.at(found->second));
  }
  const wire::PublicKey* key = keys_ ? keys_->find(socket_.sender_key()) : nullptr;
  return key == nullptr ? socket_.sender_key() : key->name;
}

void BoardServer::greet(const std::string& peer, const Datum& hello) {
  const bool formed = hello.size() == 3 && hello[1].is_string() && wire::count_at(hello, 2);
  if (!formed) return refuse(peer, {"bad-frame", "a hello is (hello TELLER SESSION)", {}, {}});
  const Result<void> named = check_teller_name(hello[1].text());
  if (!named) return refuse(peer, named.error());
  if (keys_ && keys_->follow()) end_sessions_of_changed_keys();
  const wire::PublicKey* key = nullptr;
  if (!socket_.sender_key().empty()) {
    key = keys_->find(socket_.sender_key());
    if (key == nullptr) return refuse(peer, {"not-permitted", "this key is not authorised any more", {}, {}});
  }
  const std::string teller(hello[1].text());
  const Result<void> permitted = check_hello(peer, teller, key);
  if (!permitted) return refuse(peer, permitted.error());
  const Result<wire::SessionId> id = session_for(peer, teller, *wire::count_from(hello[2]), key);
  if (!id) return refuse(peer, id.error());
  sessions_[*id].heard = executor_.now();
  send(peer, list("welcome"_sym, *id, life_));
}

Result<void> BoardServer::check_hello(const std::string& peer, const std::string& teller,
                                      const wire::PublicKey* key) const {
  if (teller == wire::board_key_name) return fail("not-permitted", "nobody else is called board", to_datum(teller));
  if (key != nullptr && !wire::may_call_itself(key->name, teller)) {
    return fail("not-permitted",
                "the teller of the key " + key->name + " is called " + key->name + ", or " + key->name + "/ANYTHING",
                to_datum(teller));
  }
  const auto standing = session_of_peer_.find(peer);
  if (standing == session_of_peer_.end() || sessions_.at(standing->second).teller == teller) return {};
  return fail("not-permitted", "this connection is that of " + sessions_.at(standing->second).teller, to_datum(teller));
}

// The one that the connection has, the one asked for where it is the teller's, or a new one.
Result<wire::SessionId> BoardServer::session_for(const std::string& peer, const std::string& teller,
                                                 wire::SessionId asked, const wire::PublicKey* key) {
  if (const auto standing = session_of_peer_.find(peer); standing != session_of_peer_.end()) return standing->second;
  const auto is_of_key = [&](const Session& session) {
    return key == nullptr ? !session.key : session.key && session.key->key == key->key;
  };
  const auto known = sessions_.find(asked);
  const bool its_own = known != sessions_.end() && known->second.teller == teller && is_of_key(known->second);
  if (its_own) {
    // One that was restored knows no more of its key than which it is.
    if (key != nullptr) known->second.key = *key;
    move_session(asked, known->second, peer);
    return asked;
  }
  if (sessions_.size() >= max_sessions) return fail("too-large", "the board has too many clients");
  const auto of_key = std::ranges::count_if(sessions_, [&](const auto& entry) { return is_of_key(entry.second); });
  if (key != nullptr && of_key >= static_cast<std::ptrdiff_t>(max_sessions_of_a_key)) {
    return fail("too-large", "too many clients come with the key " + key->name);
  }
  const auto of_name = std::ranges::count_if(
      sessions_, [&](const auto& entry) { return !entry.second.key && entry.second.teller == teller; });
  if (key == nullptr && of_name >= static_cast<std::ptrdiff_t>(max_sessions_of_a_name)) {
    return fail("too-large", "too many clients are called " + teller, to_datum(teller));
  }
  wire::SessionId id = random_number();
  while (sessions_.contains(id)) id = random_number();
  Session& session = sessions_[id];
  session.teller = teller;
  session.peer = peer;
  if (key != nullptr) session.key = *key;
  session_of_peer_[peer] = id;
  return id;
}

// The client connected anew, and what was under way to its former connection may be lost.
void BoardServer::move_session(wire::SessionId id, Session& session, const std::string& peer) {
  session_of_peer_.erase(session.peer);
  session_of_peer_[peer] = id;
  session.peer = peer;
  session.watches.begin_again();
  schedule_flush(id);
}

void BoardServer::end_session(wire::SessionId id) {
  const auto session = sessions_.find(id);
  session_of_peer_.erase(session->second.peer);
  const std::string teller = session->second.teller;
  sessions_.erase(session);
  const bool others = std::ranges::any_of(sessions_, [&](const auto& entry) { return entry.second.teller == teller; });
  if (!others) board_.statistics().left(teller);
}

// Ends the sessions of keys that are gone or have other permissions now; who still has a key says hello again.
void BoardServer::end_sessions_of_changed_keys() {
  for (const Failure& fault : keys_->faults()) refusals_.note("", fault);
  std::vector<wire::SessionId> ended;
  for (const auto& [id, session] : sessions_) {
    if (!session.key || session.peer.empty()) continue;
    const wire::PublicKey* now = keys_->find(session.key->key);
    if (now == nullptr || *now != *session.key) ended.push_back(id);
  }
  for (const wire::SessionId id : ended) {
    send(sessions_.at(id).peer, list("unknown-session"_sym, id));
    end_session(id);
  }
}

void BoardServer::forget_the_gone() {
  const Time now = executor_.now();
  const Time heard_until = socket_.heard_until();
  std::vector<wire::SessionId> gone;
  for (const auto& [id, session] : sessions_) {
    if (session.heard + session_length_ <= heard_until) gone.push_back(id);
  }
  for (const wire::SessionId id : gone) end_session(id);
  permitted_.sweep();
  if (keys_ && keys_->refresh()) end_sessions_of_changed_keys();
  sweep_timer_ = executor_.call_at(now + session_length_ / 8, [this] { forget_the_gone(); });
}

}  // namespace pizarra::server
