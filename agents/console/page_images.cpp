#include "agents/console/page_images.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

constexpr ReadLimits word_limits{.bytes = 256, .depth = 2, .elements = 8};

}  // namespace

PageImages::PageImages(Executor& executor, ImageFeeds& feeds, const Pulse& pulse, Words words)
    : executor_(executor), feeds_(feeds), pulse_(pulse), words_(std::move(words)) {}
PageImages::~PageImages() = default;

bool PageImages::look(const std::string& name) {
  if (streams_.contains(name)) return true;
  if (streams_.size() >= max_streams) return false;
  Stream& stream = streams_[name];
  stream.look = feeds_.look(name, [this, &stream](const auto& picture) {
    stream.newest = picture;
    send_what_waits();
  });
  say_wishes();
  return true;
}

void PageImages::look_away(const std::string& name) { streams_.erase(name); }

void PageImages::add_lane(web::UpgradedSocket socket) {
  if (!takes_lane()) return;
  const auto lane = lanes_.emplace(lanes_.end());
  web::WebSocket::Events events{.text = [this, lane](std::string_view message) { hear(*lane, message); },
                                .room = [] {},
                                .ended =
                                    [this, lane] {
                                      lanes_.erase(lane);
                                      send_what_waits();
                                    }};
  lane->socket = std::make_unique<web::WebSocket>(executor_, std::move(socket), std::move(events));
  send_what_waits();
}

void PageImages::hear(Lane& lane, std::string_view message) {
  const Result<Datum> form = read_one(message, word_limits);
  const bool drawn = form && form->is_form("drawn") && form->size() == 2 && (*form)[1].is_integer();
  if (drawn && !lane.stream.empty()) {
    note_drawn(lane, std::clamp<std::int64_t>((*form)[1].integer(), 0, 60'000) * 1ms);
  } else if (drawn || !form || !words_(*form)) {
    lane.socket->close(1008, "not understood");
  }
}

void PageImages::note_drawn(Lane& lane, Duration drawing) {
  const Duration line = pulse_.line().value_or(Duration(0));
  lane.image.waited = std::max(Duration(0), executor_.now() - lane.image.sent - drawing - line);
  size_.note(lane.image);
  lane.stream.clear();
  renew_if_slow(lane, line);
  send_what_waits();
}

// One each half second at most, so that the others go on with the images.
void PageImages::renew_if_slow(Lane& lane, Duration line) {
  const bool slow = line > longest_near && lane.image.waited >= line;
  if (!slow || executor_.now() - renewed_ < between_renewals) return;
  renewed_ = executor_.now();
  lane.socket->send(web::WebSocket::Class::control, "(renew)");
}

void PageImages::send_what_waits() {
  while (Lane* lane = free_lane()) {
    auto* next = next_stream();
    if (next == nullptr) break;
    send(*lane, next->first, next->second);
  }
  say_wishes();
}

// Nothing is made ready for a page that could not be sent it now.
void PageImages::say_wishes() {
  const bool free = free_lane() != nullptr;
  for (auto& [name, stream] : streams_) {
    const bool takes = free && under_way(name) < most_under_way();
    const ImageFeeds::Size size = size_.is_light() ? ImageFeeds::Size::light : ImageFeeds::Size::full;
    stream.look->want(takes ? std::optional(size) : std::nullopt);
  }
}

// The one that was the quickest lately: one that lost a packet sends slowly for a while.
PageImages::Lane* PageImages::free_lane() {
  Lane* quickest = nullptr;
  for (Lane& lane : lanes_) {
    if (lane.stream.empty() && (quickest == nullptr || lane.image.waited < quickest->image.waited)) quickest = &lane;
  }
  return quickest;
}

// The one that was sent least lately, of those that have an image which may go.
std::pair<const std::string, PageImages::Stream>* PageImages::next_stream() {
  std::pair<const std::string, Stream>* next = nullptr;
  const std::size_t bytes = bytes_under_way();
  for (auto& entry : streams_) {
    const auto& [name, stream] = entry;
    if (!stream.newest || under_way(name) >= most_under_way()) continue;
    const bool fits = bytes == 0 || bytes + stream.newest->jpeg.size() <= max_bytes_under_way;
    if (fits && (next == nullptr || stream.sent < next->second.sent)) next = &entry;
  }
  return next;
}

std::size_t PageImages::under_way(const std::string& stream) const {
  return static_cast<std::size_t>(std::ranges::count(lanes_, stream, &Lane::stream));
}

std::size_t PageImages::bytes_under_way() const {
  std::size_t bytes = 0;
  for (const Lane& lane : lanes_) bytes += lane.stream.empty() ? 0 : lane.image.bytes;
  return bytes;
}

std::size_t PageImages::most_under_way() const {
  const Duration line = pulse_.line().value_or(Duration(0));
  return line > longest_near ? max_under_way : 2;
}

void PageImages::send(Lane& lane, const std::string& name, Stream& stream) {
  const auto picture = std::exchange(stream.newest, nullptr);
  stream.sent = executor_.now();
  lane.stream = name;
  lane.image = {stream.sent, picture->jpeg.size(), picture->full_bytes, lane.image.waited};
  lane.socket->send(web::WebSocket::Class::images, fmt::format("(image {} {} {} {} {})\n{}", name, picture->number,
                                                               picture->captured.time_since_epoch().count(),
                                                               picture->width, picture->height, picture->jpeg));
}

}  // namespace pizarra::console
