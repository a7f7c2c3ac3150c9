#include "drivers/simulation/simulated_camera.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

constexpr Duration image_time = 2s;

bool fits(const std::shared_ptr<const Image>& image, bool colour) {
  if (!image || image->channels != (colour ? 3 : 1)) return false;
  const auto size = static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height);
  return image->pixels.size() == size * static_cast<std::size_t>(image->channels);
}

}  // namespace

Task<Result<camera::StereoModel>> SimulatedCamera::open() {
  const Datum request = list("camera"_sym, "open"_sym);
  const Result<Message> answer = co_await link_.call(request, image_time);
  if (!answer) co_return fail(answer);
  const Datum& head = answer->head;
  if (head.size() != 6) co_return fail("disconnected", "the camera answered nonsense", head);
  co_return camera::StereoModel{static_cast<int>(head[0].integer()),
                                static_cast<int>(head[1].integer()),
                                head[2].number(),
                                head[3].number(),
                                head[4].number(),
                                head[5].number()};
}

Task<Result<camera::StereoFrame>> SimulatedCamera::next(Time after, bool colour) {
  const Datum kind = colour ? "colour"_sym : "grey"_sym;
  const Datum request = list("camera"_sym, "next"_sym, after.time_since_epoch().count(), kind);
  const Time asked = executor_.now();
  const Result<Message> answer = co_await link_.call(request, image_time);
  if (!answer) co_return fail(answer);
  const bool whole = answer->head.size() == 2 && answer->images.size() == 2 && fits(answer->images[0], colour) &&
                     fits(answer->images[1], colour);
  if (!whole) co_return fail("corrupt-frame", "the frame's images have other sizes than the camera's", answer->head);
  camera::StereoFrame frame;
  frame.number = static_cast<std::uint64_t>(answer->head[0].integer());
  // No frame is from before it was asked for, whatever the world's clock says.
  frame.captured = std::clamp(Time(Duration(answer->head[1].integer())), asked, executor_.now());
  frame.left = answer->images[0];
  frame.right = answer->images[1];
  co_return frame;
}

}  // namespace pizarra::simulation
