#include "agents/console/image_feed.hpp"

#include <algorithm>
#include <cassert>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "drivers/camera/opencv_files.hpp"

namespace pizarra::console {

namespace {

constexpr int jpeg_quality = 80;
constexpr int light_quality = 35;
constexpr int light_width = 240;
constexpr Duration encoding_cost = 3ms;

std::string jpeg_of(const cv::Mat& pixels, int quality) {
  const Result<camera::ImageBytes> bytes = camera::encoded_image(".jpg", pixels, {cv::IMWRITE_JPEG_QUALITY, quality});
  assert(bytes);
  return {bytes->begin(), bytes->end()};
}

cv::Mat pixels_of(const Image& image) {
  return {image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data())};
}

void encode_picture(ImageFeeds::Picture& into, const Image& image, bool full, bool light) {
  if (full) into.jpeg = full_jpeg(image);
  if (!light) return;
  const cv::Mat pixels = pixels_of(image);
  cv::Mat small = pixels;
  if (image.width > light_width) {
    cv::resize(pixels, small, {light_width, image.height * light_width / image.width}, 0, 0, cv::INTER_AREA);
  }
  into.light = jpeg_of(small, light_quality);
}

}  // namespace

bool can_be_encoded(const Image& image) {
  const bool coloured = image.channels == 1 || image.channels == 3;
  const auto size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  return coloured && size > 0 && image.pixels.size() == size * static_cast<std::size_t>(image.channels);
}

std::string full_jpeg(const Image& image) { return jpeg_of(pixels_of(image), jpeg_quality); }

class ImageFeeds::Feed {
 public:
  // `came`: a frame waits to be encoded.
  Feed(Streams& streams, const std::string& stream, const std::function<void()>& came)
      : subscription_(streams.subscribe(stream, [this, came](const StreamFrame& frame) {
          if (!can_be_encoded(*frame.image)) return;
          newest_ = frame;
          came();
        })) {}

  void add(std::uint64_t number, Receiver receiver) {
    if (shown_) receiver(shown_);
    receivers_.emplace(number, Looking{std::move(receiver)});
  }
  void set_light(std::uint64_t number, bool light) { receivers_.at(number).light = light; }
  // Whether nobody looks any more.
  bool remove(std::uint64_t number) {
    receivers_.erase(number);
    return receivers_.empty();
  }
  // Of what time the frame is that waits, if one does.
  std::optional<Time> waits_since() const { return newest_ ? std::optional(newest_->captured) : std::nullopt; }
  StreamFrame take_newest() { return *std::exchange(newest_, std::nullopt); }
  bool is_wanted(bool light) const {
    return std::ranges::any_of(receivers_, [light](const auto& entry) { return entry.second.light == light; });
  }
  void show(const std::shared_ptr<const Picture>& made) {
    shown_ = made;
    for (const auto& [number, receiver] : receivers_) receiver.show(shown_);
  }

 private:
  struct Looking {
    Receiver show;
    bool light = false;
  };

  std::map<std::uint64_t, Looking> receivers_;
  std::optional<StreamFrame> newest_;
  std::shared_ptr<const Picture> shown_;
  std::unique_ptr<Streams::Subscription> subscription_;
};

ImageFeeds::ImageFeeds(Executor& executor, Streams& streams) : executor_(executor), streams_(streams) {}
ImageFeeds::~ImageFeeds() = default;

// One at a time, of all streams, so that the console takes one core at most of those that the cell works on.
Task<void> ImageFeeds::encode_what_waits() {
  while (const auto* waiting = longest_waiting()) {
    const std::string stream = waiting->first;
    const StreamFrame frame = waiting->second->take_newest();
    const auto made = std::make_shared<Picture>();
    made->number = frame.number;
    made->captured = frame.captured;
    made->width = frame.image->width;
    made->height = frame.image->height;
    const bool light = waiting->second->is_wanted(true);
    const bool full = waiting->second->is_wanted(false);
    const std::function<void(const std::function<bool()>&)> work = [made, full, light,
                                                                    image = frame.image](const std::function<bool()>&) {
      encode_picture(*made, *image, full, light);
    };
    co_await executor_.offload(work, encoding_cost);
    const auto feed = feeds_.find(stream);
    if (feed != feeds_.end()) feed->second->show(made);
  }
}

const std::pair<const std::string, std::unique_ptr<ImageFeeds::Feed>>* ImageFeeds::longest_waiting() const {
  const std::pair<const std::string, std::unique_ptr<Feed>>* longest = nullptr;
  for (const auto& entry : feeds_) {
    const std::optional<Time> since = entry.second->waits_since();
    if (since && (longest == nullptr || *since < *longest->second->waits_since())) longest = &entry;
  }
  return longest;
}

std::unique_ptr<ImageFeeds::Look> ImageFeeds::look(const std::string& stream, Receiver receiver) {
  std::unique_ptr<Feed>& feed = feeds_[stream];
  const auto came = [this] {
    if (encoding_.done()) encoding_ = executor_.spawn(encode_what_waits());
  };
  if (!feed) feed = std::make_unique<Feed>(streams_, stream, came);
  const std::uint64_t number = next_look_++;
  feed->add(number, std::move(receiver));
  return std::make_unique<Look>(*this, stream, number);
}

ImageFeeds::Look::Look(ImageFeeds& feeds, std::string stream, std::uint64_t number)
    : feeds_(feeds), stream_(std::move(stream)), number_(number) {}

void ImageFeeds::Look::set_light(bool light) { feeds_.feeds_.at(stream_)->set_light(number_, light); }

ImageFeeds::Look::~Look() {
  const auto feed = feeds_.feeds_.find(stream_);
  if (feed->second->remove(number_)) feeds_.feeds_.erase(feed);
}

}  // namespace pizarra::console
