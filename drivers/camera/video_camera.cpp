#include "drivers/camera/video_camera.hpp"

#include <fmt/format.h>

#include "blackboard/time/detached_work.hpp"
#include "drivers/camera/frame_source.hpp"

namespace pizarra::camera {
namespace {

constexpr Duration longest_opening = 10s;
constexpr Duration longest_ending = 5s;
constexpr Duration longest_farewell = 1s;
constexpr Duration longest_silence = 3s;  // three images of the slowest rate that may be asked for

}  // namespace

VideoCamera::VideoCamera(Executor& executor, forms::CameraSetup setup)
    : VideoCamera(executor, setup, [setup] { return sources_of(setup); }) {}

VideoCamera::VideoCamera(Executor& executor, forms::CameraSetup setup, MakeSources make_sources)
    : executor_(executor), setup_(std::move(setup)), make_sources_(std::move(make_sources)) {}

VideoCamera::~VideoCamera() {
  if (desk_) desk_->leave(longest_farewell);
}

Task<Result<StereoModel>> VideoCamera::open() {
  const bool goes_on = desk_ != nullptr && desk_->healthy(executor_.now(), longest_silence);
  if (!goes_on) {
    const Result<void> ended = co_await end_reading();
    if (!ended) co_return fail(ended);
    const Result<void> begun = begin_reading();
    if (!begun) co_return fail(begun);
  }
  const std::shared_ptr<FrameDesk> desk = desk_;
  const Time deadline = executor_.now() + longest_opening;
  while (true) {
    std::optional<Result<StereoModel>> model = desk->model(executor_.now());
    if (model) co_return std::move(*model);
    const bool woken = co_await desk->news().wait(deadline);
    if (!woken) break;
  }
  const std::string why_corrupt = desk->drops().why_corrupt;
  if (!why_corrupt.empty()) co_return fail("disconnected", why_corrupt);
  co_return fail("disconnected", fmt::format("no image came within {} s", longest_opening / 1s));
}

// A device is had by one reader at a time.
Task<Result<void>> VideoCamera::end_reading() {
  if (desk_ == nullptr) co_return Result<void>();
  // Kept alive, here and below: another may be put in its place meanwhile.
  const std::shared_ptr<FrameDesk> desk = desk_;
  desk->close();
  const Time deadline = executor_.now() + longest_ending;
  while (!desk->ended()) {
    const bool woken = co_await desk->news().wait(deadline);
    if (!woken) co_return fail("disconnected", "the camera hangs: what was asked of it before is not answered");
  }
  co_return Result<void>();
}

Result<void> VideoCamera::begin_reading() {
  std::optional<StereoCalibration> calibration;
  if (!setup_.calibration_file.empty()) {
    Result<StereoCalibration> read = read_calibration_file(setup_.calibration_file);
    if (!read) return fail(read);
    calibration = *read;
  }
  dropped_before_ = drops();
  const std::uint64_t number_before = desk_ ? desk_->number() : 0;
  desk_ = std::make_shared<FrameDesk>(executor_, number_before);
  start_detached(executor_.now(),
                 [desk = desk_, setup = setup_, calibration, make = make_sources_](const std::function<Time()>& now) {
                   read_camera({setup, calibration, make, now}, *desk);
                 });
  return {};
}

Task<Result<StereoFrame>> VideoCamera::next(Time after, bool colour) {
  if (desk_ == nullptr) co_return fail("disconnected", "the camera is not open");
  const std::shared_ptr<FrameDesk> desk = desk_;
  while (true) {
    std::optional<Result<DeskFrame>> taken = desk->take(after, colour, executor_.now());
    if (taken) {
      if (!*taken) co_return fail(taken->error());
      StereoFrame frame = (*taken)->grey;
      if (colour) {
        frame.left = (*taken)->colour_left;
        frame.right = (*taken)->colour_right;
      }
      co_return frame;
    }
    // Also what cannot be read says that the camera is there.
    const Time deadline = executor_.now() + longest_silence;
    const bool woken = co_await desk->news().wait(deadline);
    if (!woken) break;
  }
  co_return fail("disconnected", fmt::format("no image came within {} s", longest_silence / 1s));
}

CameraDrops VideoCamera::drops() const {
  CameraDrops out = dropped_before_;
  if (!desk_) return out;
  const CameraDrops now = desk_->drops();
  out.late += now.late;
  out.skewed += now.skewed;
  out.corrupt += now.corrupt;
  if (!now.why_corrupt.empty()) out.why_corrupt = now.why_corrupt;
  return out;
}

}  // namespace pizarra::camera
