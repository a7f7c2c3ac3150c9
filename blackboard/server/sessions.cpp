#include "blackboard/server/sessions.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>
#include <sys/random.h>

namespace pizarra::server {

namespace {

bool is_of_key(const Session& session, const wire::PublicKey* key) {
  return key == nullptr ? !session.key : session.key && session.key->key == key->key;
}

}  // namespace

std::uint64_t Sessions::random_number() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof number, 0) != sizeof number) throw std::runtime_error("no random numbers to be had");
  return number >> 2 | 1;
}

Session* Sessions::find(wire::SessionId id) {
  const auto found = sessions_.find(id);
  return found == sessions_.end() ? nullptr : &found->second;
}

Session* Sessions::restore(wire::SessionId id) {
  if (Session* const known = find(id)) return known;
  return sessions_.size() < most_remembered ? &sessions_[id] : nullptr;
}

std::optional<wire::SessionId> Sessions::of_peer(const std::string& peer) const {
  const auto found = of_peer_.find(peer);
  if (found == of_peer_.end()) return std::nullopt;
  return found->second;
}

Result<Sessions::Begun> Sessions::begin(const std::string& peer, const std::string& teller, wire::SessionId asked,
                                        const wire::PublicKey* key) {
  if (const auto standing = of_peer(peer)) return Begun{*standing};
  Session* known = find(asked);
  const bool moves = known != nullptr && known->teller == teller && is_of_key(*known, key);
  if (!moves) {
    const Result<void> room = check_room(teller, key);
    if (!room) return fail(room);
    do asked = number_();
    while (sessions_.contains(asked));
    known = &sessions_[asked];
    known->teller = teller;
  }
  // One that was restored knows no more of its key than which it is.
  if (key != nullptr) known->key = *key;
  of_peer_.erase(known->peer);
  of_peer_[peer] = asked;
  known->peer = peer;
  if (moves) known->watches.begin_again();
  return Begun{asked, moves};
}

Result<void> Sessions::check_room(const std::string& teller, const wire::PublicKey* key) const {
  if (of_peer_.size() >= most) return fail("too-large", "the board has too many clients");
  const auto own = std::ranges::count_if(sessions_, [&](const auto& entry) {
    const Session& session = entry.second;
    return !session.peer.empty() && is_of_key(session, key) && (key != nullptr || session.teller == teller);
  });
  const std::size_t most_of_its = key != nullptr ? most_of_a_key : most_of_a_name;
  if (own < static_cast<std::ptrdiff_t>(most_of_its)) return {};
  if (key != nullptr)
    return fail("too-large",
                fmt::format("{} clients with the key {} are here, and no more may come", most_of_its, key->name));
  return fail("too-large", fmt::format("{} clients are called {}, and no more may come", most_of_its, teller),
              to_datum(teller));
}

bool Sessions::end(wire::SessionId id) {
  const auto session = sessions_.find(id);
  of_peer_.erase(session->second.peer);
  const std::string teller = session->second.teller;
  sessions_.erase(session);
  return std::ranges::none_of(sessions_, [&](const auto& entry) { return entry.second.teller == teller; });
}

}  // namespace pizarra::server
