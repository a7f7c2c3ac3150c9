#include "blackboard/memory/client_requests.hpp"

namespace pizarra::memory {

namespace {

constexpr Duration remembered = 60s;

}  // namespace

Result<void> ClientRequests::ask(const std::string& client, Time now) {
  Entry& entry = entry_of(client, now);
  const bool company = in_company(entry, now);
  Asked& asked = entry.second;
  ++asked.requests;
  asked.rate.count(now);
  asked.newest = now;
  if (now - asked.window_begun >= limit_.window) {
    asked.window_begun = now;
    asked.in_window = 0;
  }
  if (++asked.in_window <= limit_.most || !company) return {};
  ++asked.refused;
  return fail("too-many",
              "the clients called " + client + " ask more than " + std::to_string(limit_.most) + " times in " +
                  std::to_string(std::chrono::floor<std::chrono::milliseconds>(limit_.window).count()) +
                  " ms while others ask, too",
              to_datum(client));
}

// Whether somebody else asked within the last window.
bool ClientRequests::in_company(Entry& asking, Time now) {
  if (newest_ != &asking) {
    if (newest_ != nullptr) other_asked_ = newest_->second.newest;
    newest_ = &asking;
  }
  return other_asked_ && now - *other_asked_ < limit_.window;
}

// Most requests are of the client that asked before.
ClientRequests::Entry& ClientRequests::entry_of(const std::string& client, Time now) {
  if (newest_ != nullptr && newest_->first == client) return *newest_;
  if (clients_.size() >= most_clients && !clients_.contains(client)) {
    std::erase_if(clients_,
                  [&](const Entry& entry) { return &entry != newest_ && entry.second.newest + remembered <= now; });
  }
  const bool full = clients_.size() >= most_clients && !clients_.contains(client);
  return *clients_.try_emplace(full ? "others" : client).first;
}

const std::map<std::string, ClientRequests::Asked>& ClientRequests::clients(Time now) {
  for (auto& [client, asked] : clients_) asked.rate.pass_to(now);
  return clients_;
}

}  // namespace pizarra::memory
