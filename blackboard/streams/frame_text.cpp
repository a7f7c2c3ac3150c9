#include "blackboard/streams/frame_text.hpp"

#include <array>
#include <cstring>

#include "blackboard/streams/shared_ring.hpp"

namespace pizarra {

namespace {

enum Word : std::size_t { number, captured_us, width, height, channels, words };
using Header = std::array<std::uint64_t, words>;

}  // namespace

std::string frame_to_text(const std::string& stream, const StreamFrame& frame) {
  const Image& image = *frame.image;
  const Header header{frame.number, static_cast<std::uint64_t>(frame.captured.time_since_epoch().count()),
                      static_cast<std::uint64_t>(image.width), static_cast<std::uint64_t>(image.height),
                      static_cast<std::uint64_t>(image.channels)};
  std::string text = frame_topic(stream);
  text.reserve(text.size() + sizeof header + image.pixels.size());
  text.append(reinterpret_cast<const char*>(header.data()), sizeof header);
  text.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size());
  return text;
}

std::optional<StreamFrame> frame_from_text(const std::string& stream, std::string_view text) {
  const std::string topic = frame_topic(stream);
  Header header{};
  if (!text.starts_with(topic) || text.size() < topic.size() + sizeof header) return std::nullopt;
  std::memcpy(header.data(), text.data() + topic.size(), sizeof header);
  const std::string_view pixels = text.substr(topic.size() + sizeof header);
  if (!is_image(header[width], header[height], header[channels], pixels.size())) return std::nullopt;
  auto image = std::make_shared<Image>();
  image->width = static_cast<int>(header[width]);
  image->height = static_cast<int>(header[height]);
  image->channels = static_cast<int>(header[channels]);
  image->pixels.assign(pixels.begin(), pixels.end());
  return StreamFrame{header[number], Time(Duration(header[captured_us])), std::move(image)};
}

}  // namespace pizarra
