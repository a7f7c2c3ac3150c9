#pragma once

// Where the thread that reads a camera leaves its newest frame, and the agents' thread finds it. One frame lies there
// at most: a newer one replaces it. Both threads hold it.
//
//   const auto desk = std::make_shared<FrameDesk>(executor, 0);
//   desk->put(frame, model);               // the reader
//   std::optional<Result<DeskFrame>> frame = desk->take(after, false, executor.now());    // the agents
//   const bool woken = co_await desk->news().wait(deadline);              // where there was none
//   desk->close();                         // the reader finds closing(), lets the device go and ends

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

#include "blackboard/time/latch.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::camera {

struct DeskFrame {
  StereoFrame grey;
  // Made only while somebody asks for colour.
  std::shared_ptr<const Image> colour_left;
  std::shared_ptr<const Image> colour_right;
};

class FrameDesk : public std::enable_shared_from_this<FrameDesk> {
 public:
  // Frames are numbered above `number`.
  FrameDesk(Executor& executor, std::uint64_t number)
      : executor_(&executor), news_(executor), number_(number), asked_(executor.now()) {}

  // ---- for the reader
  void put(DeskFrame frame, const StereoModel& model);
  // The frame of this moment cannot be had.
  void leave_out(Time captured, std::string why);
  // No frame will come any more.
  void end(Failure failure);
  // Whether nothing is wanted any more, also because nobody has asked for a while.
  bool closing(Time now) const;
  bool colour_wanted() const;
  // Ends early when the desk closes.
  void wait(Duration duration);
  void count_skewed(std::uint64_t skewed);

  // ---- for the agents
  // The newest frame, where it was captured later than `after`, or why none will be; nothing while there is neither.
  std::optional<Result<DeskFrame>> take(Time after, bool colour, Time now);
  // Of the frames put, or why there will be none; nothing while there is neither.
  std::optional<Result<StereoModel>> model(Time now);
  // Whether the reader has let the device go.
  bool ended();
  // Wakes once for what the reader has done since somebody looked here.
  WaitList& news() { return news_; }
  // Closes, and waits until the reader has ended, so long at most. Nobody is woken any more: the executor may end.
  void leave(Duration longest);
  // Whether frames come, and the newest that the camera gave is not longer ago than this.
  bool healthy(Time now, Duration longest_silence) const;
  // Of the newest frame, also of one that could not be had.
  std::uint64_t number() const;
  void close();
  CameraDrops drops() const;

 private:
  static constexpr Duration longest_alone = 10s;
  static constexpr Duration soon = 1s;
  static constexpr int frames_in_colour = 30;

  void tell_news();

  Executor* executor_;  // of the agents; null once they have left
  WaitList news_;       // on its thread
  mutable std::mutex mutex_;
  std::condition_variable changed_;  // closed or ended
  std::optional<DeskFrame> newest_;
  std::optional<StereoModel> model_;
  std::optional<Failure> ended_;
  bool taken_ = true;
  bool told_ = false;  // that there is news, and nobody has looked since
  bool closed_ = false;
  int colour_left_ = 0;
  std::uint64_t number_;
  Time given_ = {};  // the newest frame, also one that could not be had
  Time asked_;
  CameraDrops drops_;
};

}  // namespace pizarra::camera
