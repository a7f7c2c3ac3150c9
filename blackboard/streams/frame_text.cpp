#include "blackboard/streams/frame_text.hpp"

#include <array>
#include <cstring>

#include "blackboard/streams/shared_ring.hpp"

namespace pizarra::streams {

namespace {

struct HeaderWord {
  enum : std::size_t { number, captured_us, width, height, channels, count };
};
using Header = std::array<std::uint64_t, HeaderWord::count>;

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
  if (!is_image(header[HeaderWord::width], header[HeaderWord::height], header[HeaderWord::channels], pixels.size()))
    return std::nullopt;
  auto image = std::make_shared<Image>();
  image->width = static_cast<int>(header[HeaderWord::width]);
  image->height = static_cast<int>(header[HeaderWord::height]);
  image->channels = static_cast<int>(header[HeaderWord::channels]);
  image->pixels.assign(pixels.begin(), pixels.end());
  return StreamFrame{header[HeaderWord::number], Time(Duration(header[HeaderWord::captured_us])), std::move(image)};
}

}  // namespace pizarra::streams
