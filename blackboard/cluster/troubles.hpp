#pragma once

// Which troubles of a log get a line. The sentences of absent members take turns, so the pauses between lines double:
// up to an hour between two sentences, up to a minute between trouble and no trouble.
//
//   Troubles troubles;
//   if (const std::optional<std::string> line = troubles.news(result, now)) print(*line);      // after each attempt

#include <optional>
#include <string>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::cluster {

class Troubles {
 public:
  std::optional<std::string> news(const Result<void>& result, Time now);

 private:
  // Lets through what comes seldom; twice as seldom each time, until nothing came for long.
  class Gate {
   public:
    explicit Gate(Duration longest) : longest_(longest) {}
    bool opens(Time now);

   private:
    const Duration longest_;
    Duration pause_{};
    Time next_{};
  };

  std::string said_;  // empty: that all is well
  Gate turns_{std::chrono::minutes(1)};
  Gate sentences_{std::chrono::hours(1)};
};

}  // namespace pizarra::cluster
