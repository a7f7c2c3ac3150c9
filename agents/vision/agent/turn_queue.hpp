#pragma once

// The order of requests at the eyes. Requests of one client are done one after another, as they were asked. Requests
// that exclude others take turns by client: after its turn a client is the last again. Brief requests go before
// learnings, but only so many before each.
//
//   TurnQueue turns;
//   Result<int> mine = turns.enter("planner", TurnQueue::Kind::brief, now);   // fails with `busy`
//   while (!turns.is_next(*mine)) ...                                         // wait until another one leaves
//   turns.begin(*mine);
//   turns.leave(*mine, now);                                                  // also where it never began
//
// A request waits for others since its own client's request before it was done (first_since). A client that gives up
// waiting keeps its place for when it asks again.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra::vision {

class TurnQueue {
 public:
  // A request that excludes nobody and waits for its own client's requests alone; one that excludes others for a
  // moment; and one that excludes them for two seconds.
  enum class Kind : std::uint8_t { beside, brief, learning };

  // Fewer than a service handles at once, so that what need not wait is always answered.
  static constexpr std::size_t most = 48;
  static constexpr std::size_t most_of_one = 8;

  // The request's number. Where all places are taken, the client with the most requests makes room for one with none:
  // its last one is refused.
  Result<int> enter(const std::string& client, Kind kind, Time now);
  // False for one that had to make room.
  bool waits(int number) const { return position(number).has_value(); }
  // Whether all that its client asked for before is done.
  bool is_first_of_its_client(int number) const;
  // Since when it is that.
  Time first_since(int number) const { return turns_[*position(number)].first_since; }
  // Whether it may begin.
  bool is_next(int number) const;
  void begin(int number) { turns_[*position(number)].begun = true; }
  void leave(int number, Time now);
  // The client of the excluding request that is being done, or is the next; empty where there is none.
  std::string served() const;

 private:
  struct Turn {
    int number;
    std::string client;
    Kind kind;
    bool begun = false;
    std::int64_t place = 0;  // in the round; 0: not the first of its client
    Time first_since = {};
    // The least goes first.
    std::int64_t rank() const { return place + (kind == Kind::learning ? longest_put_off : 0); }
  };
  // Before a learning go so many that are soon done and came later, at most.
  static constexpr std::int64_t longest_put_off = 64;

  std::optional<std::size_t> position(int number) const;
  std::size_t count_of(const std::string& client) const;
  bool make_room();
  // The first request of this client takes its place in the round.
  void line_up(const std::string& client, Time now);
  void keep_place(const Turn& turn);

  std::vector<Turn> turns_;  // as they were asked for
  int last_number_ = 0;
  std::int64_t last_place_ = 0;
  std::map<std::string, std::int64_t> kept_places_;  // of those who gave up
};

}  // namespace pizarra::vision
