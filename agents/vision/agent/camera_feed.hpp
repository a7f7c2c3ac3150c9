#pragma once

// Keeps a stereo camera open while frames are wanted, and hands out its frames. A camera that fails is opened again,
// after 0.2 s at first, then after ever longer up to 5 s.
//
//   CameraFeed feed(executor, camera, on_frame, on_change);
//   feed.start();
//   Result<StereoFrame> frame = co_await feed.next(executor.now(), 3s);      // never one from before
//   feed.stop();                                   // ends after the frame in hand
//   feed.abandon();                                // at once; not from inside a handler

#include <deque>
#include <functional>

#include "blackboard/time/latch.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

class CameraFeed {
 public:
  enum class State : std::uint8_t { closed, opening, open, lost };
  using FrameHandler = std::function<Task<void>(camera::StereoFrame)>;
  using ChangeHandler = std::function<Task<void>()>;

  // `on_frame` sees every frame, after those who wait for it were woken; `on_change` every change of state.
  CameraFeed(Executor& executor, camera::StereoCamera& camera, FrameHandler on_frame, ChangeHandler on_change);

  void start();
  void stop() { wanted_ = false; }
  void abandon();

  bool wanted() const { return wanted_; }
  State state() const { return state_; }
  // Why it is lost; empty otherwise.
  const std::string& trouble() const { return trouble_; }
  // Of the camera opened last.
  const std::optional<camera::StereoModel>& model() const { return model_; }
  // 0 before the first frame.
  std::uint64_t frame_number() const { return latest_.number; }
  Time latest() const { return latest_.captured; }

  // The newest frame, where it was captured later than `after`, else the next that was. Failure `no-image` when none
  // comes in time.
  Task<Result<camera::StereoFrame>> next(Time after, Duration timeout);

  // Recent frames are kept, for a person who points at something that has moved on since.
  static constexpr std::size_t most_kept = 200;
  static constexpr std::size_t most_kept_bytes = 48 << 20;
  // The frame of this number, or the first one after it where nobody took that one. Failure: frame-gone.
  Result<camera::StereoFrame> kept(std::uint64_t number) const;
  // The first of those that were captured later than `after`, kept or to come. Failure: no-image.
  Task<Result<camera::StereoFrame>> next_in_turn(Time after, Duration timeout);

 private:
  Task<void> run();
  // The first frame that the camera captures later than `after`.
  Task<void> capture(Time after);
  Task<void> change_to(State state, std::string trouble);
  void keep(const camera::StereoFrame& frame);

  Executor& executor_;
  camera::StereoCamera& camera_;
  FrameHandler on_frame_;
  ChangeHandler on_change_;
  bool wanted_ = false;
  State state_ = State::closed;
  std::string trouble_;
  std::optional<camera::StereoModel> model_;
  camera::StereoFrame latest_;            // since the camera was opened
  std::deque<camera::StereoFrame> kept_;  // the same
  std::size_t kept_bytes_ = 0;
  WaitList waiting_;
  Job job_;
};

}  // namespace pizarra::vision
