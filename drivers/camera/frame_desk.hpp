#pragma once

// Where the thread that reads a camera leaves its newest frame, and the agents' thread finds it. One frame lies there
// at most: a newer one replaces it.
//
//   FrameDesk desk(ring, now, 0);          // `ring` is called, by the reader, once for what is new
//                                        // since somebody looked
//   desk.put(frame, model);                // the reader
//   std::optional<Result<DeskFrame>> frame = desk.take(after, false, now);    // the agents
//   desk.close();                          // the reader finds closing(), lets the device go and ends

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::camera {

struct DeskFrame {
  StereoFrame grey;
  // Made only while somebody asks for colour.
  std::shared_ptr<const Image> colour_left;
  std::shared_ptr<const Image> colour_right;
};

class FrameDesk {
 public:
  // Frames are numbered above `number`.
  FrameDesk(std::function<void()> ring, Time now, std::uint64_t number)
      : ring_(std::move(ring)), number_(number), asked_(now) {}

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
  // Waits for that, so long at most.
  bool wait_for_end(Duration duration);
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

  void ring_once(std::unique_lock<std::mutex> lock);

  const std::function<void()> ring_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;  // closed or ended
  std::optional<DeskFrame> newest_;
  std::optional<StereoModel> model_;
  std::optional<Failure> ended_;
  bool taken_ = true;
  bool rung_ = false;  // and nobody has looked since
  bool closed_ = false;
  int colour_left_ = 0;
  std::uint64_t number_;
  Time given_ = {};  // the newest frame, also one that could not be had
  Time asked_;
  CameraDrops drops_;
};

}  // namespace pizarra::camera
