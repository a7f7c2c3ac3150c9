#include "agents/pan_tilt/head_control.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::pan_tilt {

namespace {

Result<void> check_axis(std::string_view name, const ptu::PanTiltAxisRange& range, std::optional<double> deg) {
  if (!deg || (*deg >= range.low_deg && *deg <= range.high_deg)) return {};
  return fail("out-of-range",
              fmt::format("the head's {} goes from {:.2f} to {:.2f} degrees, not to {:.2f}", name, range.low_deg,
                          range.high_deg, *deg),
              Datum::symbol(name));
}

// A count inside the limit, so that rounding does not lead out of them.
std::optional<double> clamped(std::optional<double> deg, const ptu::PanTiltAxisRange& range) {
  if (!deg) return deg;
  return std::clamp(*deg, range.low_deg + range.resolution_deg, range.high_deg - range.resolution_deg);
}

}  // namespace

// While it lives, the head counts as moving, whatever is read.
class HeadControl::Moving {
 public:
  explicit Moving(HeadControl& head) : head_(head) { ++head_.under_way_; }
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;
  ~Moving() {
    --head_.under_way_;
    head_.changed_.wake_all();
  }

 private:
  HeadControl& head_;
};

Task<void> HeadControl::run() {
  while (true) {
    if (!wanted_) {
      co_await changed_.wait();
      continue;
    }
    const Result<void> connected = co_await connect();
    if (connected) {
      co_await watch();
      continue;
    }
    co_await lose(connected.error());
    const Time again = context_.executor.now() + reconnect_pause;
    co_await changed_.wait(again);
  }
}

Task<Result<void>> HeadControl::connect() {
  state_ = State::connecting;
  const Result<ptu::PanTiltRange> range = co_await driver_.connect();
  if (!range) co_return fail(range);
  range_ = *range;
  const Result<void> sped = co_await apply_speeds();
  if (!sped) co_return sped;
  const Result<ptu::PanTiltReading> reading = co_await driver_.read();
  if (!reading) co_return fail(reading);
  if (!wanted_) co_return fail("closed", "the pan-tilt unit was closed");
  reading_ = *reading;
  moving_ = reading->moving;
  state_ = State::ready;
  facts_.set_state("ready", "");
  facts_.set_unit(range_);
  facts_.set_pose(reading_, moving_);
  co_await tell();
  changed_.wake_all();
  co_return Result<void>();
}

// Reads where it is until it is lost or closed.
Task<void> HeadControl::watch() {
  while (state_ == State::ready) {
    const Time next = context_.executor.now() + (moving_ ? poll_moving : poll_still);
    co_await changed_.wait(next);
    if (state_ != State::ready) co_return;
    const Result<ptu::PanTiltReading> reading = co_await driver_.read();
    if (!reading) {
      if (state_ == State::ready) co_await lose(reading.error());
      co_return;
    }
    reading_ = *reading;
    const bool was_moving = moving_;
    moving_ = reading->moving || under_way_ > 0;
    facts_.set_pose(reading_, moving_);
    co_await tell();
    if (was_moving && !moving_) changed_.wake_all();
  }
}

Task<void> HeadControl::lose(Failure why) {
  state_ = wanted_ ? State::connecting : State::closed;
  trouble_ = why.sentence;
  moving_ = true;
  facts_.set_state(wanted_ ? "lost" : "closed", wanted_ ? why.sentence : "");
  facts_.set_no_pose();
  co_await tell();
  changed_.wake_all();
}

// Facts that a board misses while it is away are told at the next change or look.
Task<void> HeadControl::tell() {
  const Result<void> told = co_await facts_.tell();
  static_cast<void>(told);
}

Result<void> HeadControl::usable() const {
  if (state_ == State::ready) return {};
  if (!wanted_) return fail("closed", "the pan-tilt unit is closed: pt-init opens it");
  return fail("disconnected", trouble_);
}

Result<void> HeadControl::check(const HeadMove& move) const {
  const Result<void> pan = check_axis("pan", range_.pan, move.pan_deg);
  if (!pan) return pan;
  return check_axis("tilt", range_.tilt, move.tilt_deg);
}

HeadMove HeadControl::within_range(HeadMove move) const {
  return {clamped(move.pan_deg, range_.pan), clamped(move.tilt_deg, range_.tilt)};
}

Task<Result<void>> HeadControl::open(Time deadline) {
  wanted_ = true;
  changed_.wake_all();
  while (state_ != State::ready) {
    const bool changed = co_await changed_.wait(deadline);
    if (!changed) co_return fail("disconnected", trouble_);
  }
  co_return Result<void>();
}

Task<Result<void>> HeadControl::close() {
  wanted_ = false;
  driver_.close();
  const Failure closed{"closed", "the pan-tilt unit was closed", {}, {}};
  co_await lose(closed);
  co_return Result<void>();
}

Task<Result<void>> HeadControl::move(HeadMove move) {
  const Result<void> sound = check(move);
  const Result<void> ready = usable();
  if (!ready) co_return ready;
  if (!sound) co_return sound;
  const Moving moving(*this);
  moving_ = true;
  facts_.set_pose(reading_, true);
  const Result<void> told = co_await facts_.tell();
  if (!told) co_return told;
  if (move.pan_deg) {
    const double deg = *move.pan_deg;
    const Result<void> panning = co_await driver_.move_to(ptu::PanTiltAxis::pan, deg);
    if (!panning) co_return panning;
  }
  if (move.tilt_deg) {
    const double deg = *move.tilt_deg;
    const Result<void> tilting = co_await driver_.move_to(ptu::PanTiltAxis::tilt, deg);
    if (!tilting) co_return tilting;
  }
  co_return Result<void>();
}

Task<Result<void>> HeadControl::apply_speeds() {
  const double pan = speeds_.pan_percent / 100;
  const double tilt = speeds_.tilt_percent / 100;
  const Result<void> panning = co_await driver_.set_speed(ptu::PanTiltAxis::pan, pan);
  if (!panning) co_return panning;
  const Result<void> tilting = co_await driver_.set_speed(ptu::PanTiltAxis::tilt, tilt);
  co_return tilting;
}

Task<Result<void>> HeadControl::set_speeds(HeadSpeeds speeds) {
  const Result<void> ready = usable();
  if (!ready) co_return ready;
  speeds_ = speeds;
  Result<void> applied = co_await apply_speeds();
  co_return applied;
}

Task<Result<void>> HeadControl::reset(std::optional<ptu::PanTiltAxis> axis) {
  const Result<void> ready = usable();
  if (!ready) co_return ready;
  const Moving moving(*this);
  moving_ = true;
  facts_.set_state("resetting", "");
  facts_.set_no_pose();
  const Result<void> told = co_await facts_.tell();
  if (!told) co_return told;
  Result<void> done;
  if (axis) {
    const ptu::PanTiltAxis which = *axis;
    done = co_await driver_.reset(which);
  } else {
    done = co_await driver_.reset_all();
  }
  if (done) facts_.set_state("ready", "");
  co_return done;
}

Task<Result<ptu::PanTiltReading>> HeadControl::read() {
  const Result<void> ready = usable();
  if (!ready) co_return fail(ready);
  const Result<ptu::PanTiltReading> reading = co_await driver_.read();
  co_return reading;
}

Task<bool> HeadControl::until_still(Time deadline) {
  while (state_ == State::ready && moving_) {
    const bool changed = co_await changed_.wait(deadline);
    if (!changed) co_return false;
  }
  co_return true;
}

}  // namespace pizarra::pan_tilt
