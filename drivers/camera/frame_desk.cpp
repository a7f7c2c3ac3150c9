#include "drivers/camera/frame_desk.hpp"

#include <utility>

namespace pizarra {

// Outside of the lock, for it may wake who takes it.
void FrameDesk::ring_once(std::unique_lock<std::mutex> lock) {
  if (std::exchange(rung_, true)) return;
  lock.unlock();
  ring_();
}

void FrameDesk::put(DeskFrame frame, const StereoModel& model) {
  std::unique_lock lock(mutex_);
  // Nobody misses what comes while nobody asks.
  if (!taken_ && frame.grey.captured - asked_ < soon) ++drops_.late;
  newest_ = std::move(frame);
  model_ = model;
  trouble_.reset();
  taken_ = false;
  if (colour_left_ > 0) --colour_left_;
  ring_once(std::move(lock));
}

void FrameDesk::put_trouble(Failure failure) {
  std::unique_lock lock(mutex_);
  trouble_ = std::move(failure);
  ++drops_.corrupt;
  ring_once(std::move(lock));
}

void FrameDesk::end(Failure failure) {
  std::unique_lock lock(mutex_);
  ended_ = std::move(failure);
  changed_.notify_all();
  ring_once(std::move(lock));
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

std::optional<Result<DeskFrame>> FrameDesk::take(std::uint64_t after, bool colour, Time now) {
  const std::scoped_lock lock(mutex_);
  asked_ = now;
  rung_ = false;
  if (colour) colour_left_ = frames_in_colour;
  if (trouble_) {
    Failure trouble = std::move(*trouble_);
    trouble_.reset();
    return fail(std::move(trouble));
  }
  const bool has = newest_ && newest_->grey.number > after && (!colour || newest_->colour_left != nullptr);
  if (has) {
    taken_ = true;
    return *newest_;
  }
  if (ended_) return fail(*ended_);
  return std::nullopt;
}

std::optional<Result<StereoModel>> FrameDesk::model(Time now) {
  const std::scoped_lock lock(mutex_);
  asked_ = now;
  rung_ = false;
  if (model_) return *model_;
  if (ended_) return fail(*ended_);
  if (trouble_ && drops_.corrupt >= most_corrupt_at_first) return fail(*trouble_);
  return std::nullopt;
}

bool FrameDesk::healthy(Time now, Duration longest_silence) const {
  const std::scoped_lock lock(mutex_);
  const bool silent = newest_ && now - newest_->grey.captured > longest_silence;
  return newest_ && !silent && !trouble_ && !ended_ && !closed_;
}

bool FrameDesk::ended() {
  const std::scoped_lock lock(mutex_);
  rung_ = false;
  return ended_.has_value();
}

bool FrameDesk::wait_for_end(Duration duration) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, duration, [this] { return ended_.has_value(); });
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

}  // namespace pizarra
