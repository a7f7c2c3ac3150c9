#pragma once

// A camera that takes frames of a scene at its own rate whether anybody asks or not, holds the newest, and can hang: as
// a device does behind the thread that reads it.
//
//   StreamingCamera camera(executor, 200ms);
//   camera.scene.faces = {{.mark = "circle", .place = {0, 0, 850}}};
//   camera.hangs = true;                              // the newest frame lies there, and no other comes

#include "blackboard/time/latch.hpp"
#include "tests/agents/vision/scene.hpp"

namespace pizarra::vision {

class StreamingCamera : public camera::StereoCamera {
 public:
  StreamingCamera(Executor& executor, Duration frame_period) : period(frame_period), executor_(executor) {
    taking_ = executor.spawn(take_frames());
  }

  Scene scene;
  Duration period;
  Duration decoding = {};  // from when a frame is captured until it can be had
  bool hangs = false;

  Task<Result<camera::StereoModel>> open() override { co_return model_; }
  Task<Result<camera::StereoFrame>> next(Time after, bool) override {
    const Time deadline = executor_.now() + 3s;
    while (newest_.captured <= after) {
      const bool woken = co_await came_.wait(deadline);
      if (!woken) co_return fail("disconnected", "no image came within 3 s");
    }
    co_return newest_;
  }
  const camera::StereoModel& model() const { return model_; }
  bool is_decoding() const { return decodes_; }

 private:
  Task<void> take_frames() {
    while (true) {
      co_await sleep(executor_, period);
      if (hangs) continue;
      camera::StereoFrame frame = draw_scene(scene, model_, newest_.number + 1, random_);
      frame.captured = executor_.now();
      decodes_ = true;
      if (decoding > Duration()) co_await sleep(executor_, decoding);
      decodes_ = false;
      newest_ = frame;
      came_.wake_all();
    }
  }

  Executor& executor_;
  Random random_{11};
  camera::StereoModel model_;
  camera::StereoFrame newest_;
  bool decodes_ = false;
  WaitList came_{executor_};
  Job taking_;
};

}  // namespace pizarra::vision
