#pragma once

// The clients that hold each mode of the eyes. Each connects, and tracks objects, for itself: what one ends goes on for
// the others, and whoever dies lets go of what it held. Nobody knows when a client dies that is not present on the
// board: all such clients hold what they hold as one, and only for a time.
//
//   ModeHolders holders;
//   holders.track("coordinator", {"circle"});
//   holders.end_track("person");                      // nothing: it tracks nothing
//   holders.tracker();                                // "coordinator"

#include <map>
#include <set>
#include <string>
#include <vector>

#include "agents/vision/objects/renames.hpp"
#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

class ModeHolders {
 public:
  // What is held by these, anyone may end: what was kept, and what those hold who are not present on the board.
  static constexpr std::string_view anybody = "anybody";
  static constexpr std::string_view absent = "absent";
  static constexpr Duration absent_for = 60s;  // how long such clients hold what they asked for last
  // No client is called so; failure `bad-name`.
  static Result<void> check_client(const std::string& client);

  void connect(const std::string& client) { clients_[client].connected = true; }
  void disconnect(const std::string& client);
  bool connected() const;

  void track(const std::string& client, const std::string& name);
  void end_track(const std::string& client);
  bool tracks(const std::string& client) const;
  // Another one who tracks this object, and ends that himself; empty: nobody.
  std::string other_tracker(const std::string& client, const std::string& name) const;
  // One who tracks; empty: nobody.
  std::string tracker() const;
  // Everything that is tracked, each once.
  std::set<std::string> tracked() const;
  // As MarkTracker::rename().
  void rename(const Renames& renames);

  // One learns, and then nobody tracks. Several find at once, where they look at the same frame.
  void begin_learning(const std::string& client) { learning_ = client; }
  void end_learning() { learning_.clear(); }
  bool learning() const { return !learning_.empty(); }
  void begin_finding(const std::string& client) { finding_.push_back(client); }
  void end_finding(const std::string& client) { std::erase(finding_, client); }
  bool finding() const { return !finding_.empty(); }

  // The client's modes go on without it, as anybody's. False where it holds none.
  bool keep(const std::string& client);

  // Those who are connected or track, and can die.
  std::vector<std::string> clients() const;
  // False where it held nothing.
  bool let_go(const std::string& client) { return clients_.erase(client) > 0; }

  // (vision-held CLIENT MODE) of each: connected, tracking, learning, finding.
  std::vector<Datum> facts() const;

 private:
  struct Held {
    bool connected = false;
    std::set<std::string> tracked;
    bool nothing() const { return !connected && tracked.empty(); }
  };
  void tidy() {
    std::erase_if(clients_, [](const auto& entry) { return entry.second.nothing(); });
  }

  std::map<std::string, Held> clients_;
  std::string learning_;  // empty: nobody
  std::vector<std::string> finding_;
};

}  // namespace pizarra::vision
