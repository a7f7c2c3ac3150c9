#include "tests/blackboard/streams/frames.hpp"

#include <algorithm>

namespace pizarra::streams {

namespace {

std::uint8_t shade(std::uint64_t number) { return static_cast<std::uint8_t>(number % 251); }

}  // namespace

StreamFrame numbered_frame(std::uint64_t number, int width, int height, int channels) {
  const auto bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height * channels);
  auto image = std::make_shared<Image>(Image{width, height, channels, std::vector(bytes, shade(number))});
  return {number, Time(Duration(number * 1000)), std::move(image)};
}

bool is_whole(const StreamFrame& frame) {
  const Image& image = *frame.image;
  const auto bytes = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height * image.channels);
  return frame.captured == Time(Duration(frame.number * 1000)) && image.pixels.size() == bytes &&
         std::ranges::all_of(image.pixels, [&](std::uint8_t pixel) { return pixel == shade(frame.number); });
}

}  // namespace pizarra::streams
