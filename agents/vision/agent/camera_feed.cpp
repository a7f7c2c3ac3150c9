#include "agents/vision/agent/camera_feed.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::vision {
namespace {

constexpr Duration first_pause = 200ms;
constexpr Duration longest_pause = 5s;
constexpr Duration corrupt_pause = 20ms;
constexpr int most_corrupt_frames = 20;  // in a row, before the camera is opened anew

bool fits(const camera::StereoModel& model, const std::shared_ptr<const Image>& image) {
  if (image == nullptr || image->width != model.width || image->height != model.height) return false;
  const auto bytes = static_cast<std::int64_t>(image->width) * image->height * image->channels;
  return (image->channels == 1 || image->channels == 3) && std::cmp_equal(image->pixels.size(), bytes);
}

constexpr int most_side_px = camera::largest_image.width;

std::size_t bytes_of(const camera::StereoFrame& frame) {
  return frame.left->pixels.size() + frame.right->pixels.size();
}

// Why the camera cannot be used; empty where it can.
std::string trouble_with(const camera::StereoModel& model) {
  const auto fits = [](int side) { return side >= camera::least_side_px && side <= most_side_px; };
  if (!fits(model.width) || !fits(model.height)) {
    return fmt::format("the camera's images are {0}x{1}, and what works is {2}x{2} to {3}x{3}", model.width,
                       model.height, camera::least_side_px, most_side_px);
  }
  const bool has_depth = model.base_line_mm > 0 || (model.is_single() && model.learned_at_mm > 0);
  return model.focal_px > 0 && has_depth ? "" : "the camera's model makes no sense";
}

}  // namespace

CameraFeed::CameraFeed(Executor& executor, camera::StereoCamera& camera, FrameHandler on_frame, ChangeHandler on_change)
    : executor_(executor),
      camera_(camera),
      on_frame_(std::move(on_frame)),
      on_change_(std::move(on_change)),
      waiting_(executor) {}

void CameraFeed::start() {
  wanted_ = true;
  if (job_.done()) job_ = executor_.spawn(run());
}

void CameraFeed::abandon() {
  wanted_ = false;
  job_ = Job();
  state_ = State::closed;
}

Task<Result<camera::StereoFrame>> CameraFeed::next(Time after, Duration timeout) {
  const Time deadline = executor_.now() + timeout;
  const std::uint64_t unreadable = camera_.drops().corrupt;
  bool in_time = true;
  while (in_time) {
    if (latest_.left != nullptr && latest_.captured > after) co_return latest_;
    in_time = co_await waiting_.wait(deadline);
  }
  if (!trouble_.empty()) co_return fail("no-image", trouble_);
  const camera::CameraDrops drops = camera_.drops();
  if (drops.corrupt == unreadable) co_return fail("no-image", "the camera gives no images");
  co_return fail("no-image", "the camera's images cannot be read: " + drops.why_corrupt);
}

Result<camera::StereoFrame> CameraFeed::kept(std::uint64_t number) const {
  const auto frame = std::ranges::lower_bound(kept_, number, {}, &camera::StereoFrame::number);
  const bool there = frame != kept_.end() && kept_.front().number <= number;
  if (there) return *frame;
  const std::string which = kept_.empty()
                                ? std::string("none is")
                                : fmt::format("those from {} to {} are", kept_.front().number, kept_.back().number);
  return fail("frame-gone", fmt::format("frame {} is not kept: {}", number, which), to_datum(number));
}

Task<Result<camera::StereoFrame>> CameraFeed::next_in_turn(Time after, Duration timeout) {
  const auto frame = std::ranges::upper_bound(kept_, after, {}, &camera::StereoFrame::captured);
  if (frame == kept_.end()) co_return co_await next(after, timeout);
  const camera::StereoFrame found = *frame;
  // However many are kept, requests come in between.
  co_await sleep(executor_, Duration(0));
  co_return found;
}

void CameraFeed::keep(const camera::StereoFrame& frame) {
  kept_.push_back(frame);
  kept_bytes_ += bytes_of(frame);
  while (kept_.size() > most_kept || kept_bytes_ > most_kept_bytes) {
    kept_bytes_ -= bytes_of(kept_.front());
    kept_.pop_front();
  }
}

Task<void> CameraFeed::run() {
  const std::string no_trouble;
  Duration pause = first_pause;
  while (true) {
    if (!wanted_) {
      co_await change_to(State::closed, no_trouble);
      if (!wanted_) co_return;
    }
    // A camera that was not let go meanwhile may still hold a frame of long ago.
    const Time wanted_since = executor_.now();
    if (state_ == State::closed) co_await change_to(State::opening, no_trouble);
    const Result<camera::StereoModel> model = co_await camera_.open();
    std::string trouble = model ? trouble_with(*model) : describe(model.error());
    if (trouble.empty()) {
      model_ = *model;
      latest_ = {};
      kept_.clear();
      kept_bytes_ = 0;
      co_await change_to(State::open, no_trouble);
      co_await capture(wanted_since);
      if (!wanted_) continue;
      if (latest_.number != 0) pause = first_pause;
      trouble = trouble_;
    }
    co_await change_to(State::lost, trouble);
    co_await sleep(executor_, pause);
    pause = std::min(2 * pause, longest_pause);
  }
}

Task<void> CameraFeed::capture(Time after) {
  int corrupt = 0;
  Duration rest = {};
  while (wanted_) {
    // However much a frame costs, as long again is for requests and to be present. A feed that is stopped meanwhile and
    // started again still waits for a newer frame.
    co_await sleep(executor_, rest);
    const Result<camera::StereoFrame> frame = co_await camera_.next(after, false);
    const bool good = frame && fits(*model_, frame->left) && fits(*model_, frame->right) && frame->captured > after;
    if (good) {
      corrupt = 0;
      latest_ = *frame;
      keep(*frame);
      after = frame->captured;
      waiting_.wake_all();
      const Time begun = executor_.now();
      camera::StereoFrame copy = *frame;
      co_await on_frame_(std::move(copy));
      rest = executor_.now() - begun;
      continue;
    }
    const bool broken = frame || frame.error().symbol == "corrupt-frame";
    if (broken && ++corrupt < most_corrupt_frames) {
      co_await sleep(executor_, corrupt_pause);
      continue;
    }
    trouble_ = frame ? "the camera gives corrupt images" : describe(frame.error());
    co_return;
  }
}

Task<void> CameraFeed::change_to(State state, std::string trouble) {
  if (state == state_ && trouble == trouble_) co_return;
  state_ = state;
  trouble_ = std::move(trouble);
  co_await on_change_();
}

}  // namespace pizarra::vision
