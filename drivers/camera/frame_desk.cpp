#include "drivers/camera/frame_desk.hpp"

#include <utility>

namespace pizarra::camera {

void FrameDesk::tell_news() {
  if (std::exchange(told_, true) || executor_ == nullptr) return;
  executor_->post([desk = weak_from_this()] {
    if (const std::shared_ptr<FrameDesk> here = desk.lock()) here->news_.wake_all();
  });
}

void FrameDesk::put(DeskFrame frame, const StereoModel& model) {
  const std::scoped_lock lock(mutex_);
  // Nobody misses what comes while nobody asks.
  if (!taken_ && frame.grey.captured - asked_ < soon) ++drops_.late;
  frame.grey.number = ++number_;
  given_ = frame.grey.captured;
  newest_ = std::move(frame);
  model_ = model;
  taken_ = false;
  if (colour_left_ > 0) --colour_left_;
  tell_news();
}

void FrameDesk::leave_out(Time captured, std::string why) {
  const std::scoped_lock lock(mutex_);
  ++number_;
  given_ = captured;
  ++drops_.corrupt;
  drops_.why_corrupt = std::move(why);
  tell_news();
}

void FrameDesk::end(Failure failure) {
  const std::scoped_lock lock(mutex_);
  ended_ = std::move(failure);
  changed_.notify_all();
  tell_news();
}

bool FrameDesk::closing(Time now) const {
  const std::scoped_lock lock(mutex_);
  return closed_ || now - asked_ > longest_alone;
}

bool FrameDesk::colour_wanted() const {
  const std::scoped_lock lock(mutex_);
  return colour_left_ > 0;
}

void FrameDesk::wait(Duration duration) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, duration, [this] { return closed_; });
}

void FrameDesk::count_skewed(std::uint64_t skewed) {
  const std::scoped_lock lock(mutex_);
  drops_.skewed = skewed;
}

std::optional<Result<DeskFrame>> FrameDesk::take(Time after, bool colour, Time now) {
  const std::scoped_lock lock(mutex_);
  asked_ = now;
  told_ = false;
  if (colour) colour_left_ = frames_in_colour;
  const bool fresh = newest_ && newest_->grey.captured > after;
  const bool has = fresh && (!colour || newest_->colour_left != nullptr);
  // Nor does anybody miss what is too old.
  if (has || !fresh) taken_ = true;
  if (has) return *newest_;
  if (ended_) return fail(*ended_);
  return std::nullopt;
}

std::optional<Result<StereoModel>> FrameDesk::model(Time now) {
  const std::scoped_lock lock(mutex_);
  asked_ = now;
  told_ = false;
  if (model_) return *model_;
  if (ended_) return fail(*ended_);
  return std::nullopt;
}

bool FrameDesk::healthy(Time now, Duration longest_silence) const {
  const std::scoped_lock lock(mutex_);
  return newest_ && now - given_ <= longest_silence && !ended_ && !closed_;
}

std::uint64_t FrameDesk::number() const {
  const std::scoped_lock lock(mutex_);
  return number_;
}

bool FrameDesk::ended() {
  const std::scoped_lock lock(mutex_);
  told_ = false;
  return ended_.has_value();
}

void FrameDesk::leave(Duration longest) {
  std::unique_lock lock(mutex_);
  executor_ = nullptr;
  closed_ = true;
  changed_.notify_all();
  changed_.wait_for(lock, longest, [this] { return ended_.has_value(); });
}

void FrameDesk::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

CameraDrops FrameDesk::drops() const {
  const std::scoped_lock lock(mutex_);
  return drops_;
}

}  // namespace pizarra::camera
