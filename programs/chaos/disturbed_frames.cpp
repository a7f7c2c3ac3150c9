#include "programs/chaos/disturbed_frames.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace pizarra::chaos {

namespace {

using simulation::Message;

// A client that asks so long after a frame was taken is given the next one.
constexpr Duration behind_a_frame = 1ms;

void brighten(std::span<std::uint8_t> pixels, double light) {
  for (std::uint8_t& pixel : pixels) pixel = static_cast<std::uint8_t>(std::min(255.0, pixel * light));
}

// As far as they are told of the world, both images of a pair.
std::shared_ptr<const Image> disturbed(const Image& image, const DeviceFaults& faults, Time now) {
  auto out = std::make_shared<Image>(image);
  if (now < faults.light_until) brighten(out->pixels, faults.light);
  const auto row_bytes = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  for (int y = 0; y < image.height; ++y) {
    const auto row = out->pixels.begin() + y * row_bytes;
    if (now < faults.jumps_until) {
      std::rotate(row, row + static_cast<std::ptrdiff_t>(faults.jump_px) * image.channels, row + row_bytes);
    }
    if (now < faults.hidden_until) {
      const auto from = static_cast<std::ptrdiff_t>(faults.hidden_at * image.width) * image.channels;
      const std::ptrdiff_t to = std::min(from + row_bytes / 5, row_bytes);
      std::fill(row + from, row + to, std::uint8_t{120});
    }
  }
  return out;
}

void plant_into(Message& frame, WorldProcess& world) {
  constexpr std::size_t two_seconds = 20;
  if (world.plant == "eyes-crossed") std::swap(frame.images[0], frame.images[1]);
  if (world.plant != "images-old") return;
  world.old_images.push_back(frame.images);
  if (world.old_images.size() > two_seconds) world.old_images.pop_front();
  const bool alike = world.old_images.front()[0]->channels == frame.images[0]->channels;
  if (alike) frame.images = world.old_images.front();
}

void disturb(Message& frame, WorldProcess& world, Time now) {
  if (frame.images.size() != 2) return;
  plant_into(frame, world);
  if (now < world.faults.frames_frozen_until) {
    const bool fits = world.frozen_left != nullptr && world.frozen_left->channels == frame.images[0]->channels;
    if (!fits) {
      world.frozen_left = frame.images[0];
      world.frozen_right = frame.images[1];
    }
    frame.images = {world.frozen_left, world.frozen_right};
    return;
  }
  world.frozen_left.reset();
  world.frozen_right.reset();
  const Time changed = std::max({world.faults.jumps_until, world.faults.hidden_until, world.faults.light_until});
  if (now >= changed) return;
  for (auto& image : frame.images) image = disturbed(*image, world.faults, now);
}

bool is_of_kind(const Message& frame, const Datum& request) {
  const int channels = request[3].is_symbol("colour") ? 3 : 1;
  return frame.images.size() == 2 && frame.images[0]->channels == channels;
}

}  // namespace

Task<Result<Message>> ask_frame(WorldProcess& world, Datum request) {
  const std::optional<Message> again = std::exchange(world.given_once, std::nullopt);
  const bool doubles = again && world.process.now() < world.faults.frames_doubled_until;
  if (doubles && is_of_kind(*again, request)) co_return *again;
  while (true) {
    Result<Message> frame = co_await world.world->handle(request);
    const Time now = world.process.now();
    if (now < world.faults.frames_dropped_until) {
      co_await sleep(world.process, behind_a_frame);
      continue;
    }
    const Duration late = now < world.faults.frames_late_until ? world.faults.frame_delay : Duration::zero();
    if (late > Duration::zero()) co_await sleep(world.process, late);
    if (frame) disturb(*frame, world, now);
    if (frame && now < world.faults.frames_doubled_until) world.given_once = *frame;
    co_return frame;
  }
}

}  // namespace pizarra::chaos
