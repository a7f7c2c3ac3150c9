#include "agents/vision/agent/mode_holders.hpp"

#include <algorithm>

#include "agents/vision/objects/learned.hpp"

namespace pizarra::vision {
namespace {

bool is_anyones(const std::string& holder) { return holder == ModeHolders::anybody || holder == ModeHolders::absent; }

}  // namespace

Result<void> ModeHolders::check_client(const std::string& client) {
  if (!is_anyones(client)) return {};
  return fail("bad-name", client + " is what the eyes call clients of whom they do not know: have another name",
              Datum::symbol(client));
}

void ModeHolders::disconnect(const std::string& client) {
  for (auto& [holder, held] : clients_) {
    if (holder == client || is_anyones(holder)) held.connected = false;
  }
  tidy();
}

bool ModeHolders::connected() const {
  return std::ranges::any_of(clients_, [](const auto& entry) { return entry.second.connected; });
}

void ModeHolders::track(const std::string& client, const std::string& name) { clients_[client].tracked.insert(name); }

void ModeHolders::end_track(const std::string& client) {
  for (auto& [holder, held] : clients_) {
    if (holder == client || is_anyones(holder)) held.tracked.clear();
  }
  tidy();
}

bool ModeHolders::tracks(const std::string& client) const {
  return std::ranges::any_of(clients_, [&](const auto& entry) {
    return (entry.first == client || is_anyones(entry.first)) && !entry.second.tracked.empty();
  });
}

std::string ModeHolders::other_tracker(const std::string& client, const std::string& name) const {
  const auto held = std::ranges::find_if(clients_, [&](const auto& entry) {
    if (entry.first == client || is_anyones(entry.first)) return false;
    return std::ranges::any_of(entry.second.tracked, [&](const std::string& each) { return same_name(each, name); });
  });
  return held == clients_.end() ? "" : held->first;
}

std::string ModeHolders::tracker() const {
  const auto held = std::ranges::find_if(clients_, [](const auto& entry) { return !entry.second.tracked.empty(); });
  return held == clients_.end() ? "" : held->first;
}

std::set<std::string> ModeHolders::tracked() const {
  std::set<std::string> out;
  for (const auto& [client, held] : clients_) out.insert(held.tracked.begin(), held.tracked.end());
  return out;
}

void ModeHolders::rename(const Renames& renames) {
  for (auto& [client, held] : clients_) {
    std::set<std::string> tracked;
    for (const std::string& name : held.tracked) tracked.insert(name_now(renames, name));
    held.tracked = std::move(tracked);
  }
}

bool ModeHolders::keep(const std::string& client) {
  auto held = clients_.extract(client);
  if (held.empty()) return false;
  Held& kept = clients_[std::string(anybody)];
  kept.connected |= held.mapped().connected;
  kept.tracked.merge(held.mapped().tracked);
  return true;
}

std::vector<std::string> ModeHolders::clients() const {
  std::vector<std::string> out;
  for (const auto& [client, held] : clients_) {
    if (!is_anyones(client)) out.push_back(client);
  }
  return out;
}

std::vector<Datum> ModeHolders::facts() const {
  std::vector<Datum> out;
  const auto hold = [&](const std::string& client, Datum mode) {
    out.push_back(list("vision-held"_sym, Datum::symbol(client), std::move(mode)));
  };
  for (const auto& [client, held] : clients_) {
    if (held.connected) hold(client, "connected"_sym);
    if (!held.tracked.empty()) hold(client, "tracking"_sym);
  }
  if (learning()) hold(learning_, "learning"_sym);
  for (const std::string& client : finding_) hold(client, "finding"_sym);
  return out;
}

}  // namespace pizarra::vision
