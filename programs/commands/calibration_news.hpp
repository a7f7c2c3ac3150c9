#pragma once

// Tells a board how a calibration goes, for its console to show it: docs/facts/calibration.md. A thread of its
// own tells the facts, so that no image is missed meanwhile. Where the board is slow, it tells only the newest.
//
//   Result<std::unique_ptr<CalibrationNews>> news = CalibrationNews::open(*to);
//   (*news)->tell({.state = "looking", .wanted = 20});
//   const Result<void> told = (*news)->finish();             // all of it, or why the board did not take it

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "agents/runtime/service.hpp"
#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/time/real_executor.hpp"
#include "drivers/camera/board_coverage.hpp"

namespace pizarra::programs {

class CalibrationNews {
 public:
  // The four outer corners of a board, in one image or both, px: (X1 Y1 X2 Y2 X3 Y3 X4 Y4).
  using Outlines = Datum;
  static Outlines outlines_of(const camera::BoardView& view, const camera::CalibrationBoard& board);

  struct News {
    std::string state;     // looking, fitting, done, failed
    std::string sentence;  // of that
    cv::Size image;
    std::size_t wanted = 0;
    Outlines seen;                // in the newest image
    std::string seen_sentence;    // what came of it
    std::vector<Outlines> taken;  // it only grows
    std::vector<camera::Lack> lacks;
  };

  // Takes back the facts of an earlier calibration. Failures: those of the board and the key.
  static Result<std::unique_ptr<CalibrationNews>> open(const std::string& address, const std::string& key);
  CalibrationNews(const CalibrationNews&) = delete;
  CalibrationNews& operator=(const CalibrationNews&) = delete;
  ~CalibrationNews();

  void tell(News news);
  Result<void> finish();

 private:
  CalibrationNews() = default;
  Task<void> begin();
  Task<void> tell_newest();
  std::optional<News> newest();
  bool is_over();
  Transaction step_to(const News& news);

  RealExecutor executor_;
  std::unique_ptr<client::RemoteBoard> board_;
  std::optional<runtime::AgentContext> context_;
  std::optional<runtime::Service> service_;
  Event turn_{executor_};
  Result<void> told_;
  std::size_t boards_told_ = 0;
  std::vector<std::string> lacks_told_;
  Job telling_;

  std::mutex mutex_;
  std::optional<News> newest_;
  bool finishing_ = false;
  std::jthread thread_;  // runs the executor from when the board is there
};

}  // namespace pizarra::programs
