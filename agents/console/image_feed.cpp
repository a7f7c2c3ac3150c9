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
// How many more bytes a full picture takes for a pixel, at most.
constexpr double full_to_light = 2.5;
constexpr Duration encoding_cost = 3ms;

// Its tables are made for it: a light picture is a seventh smaller by that, and its way over a slow line shorter.
std::string jpeg_of(const cv::Mat& pixels, int quality) {
  const Result<camera::ImageBytes> bytes =
      camera::encoded_image(".jpg", pixels, {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
  assert(bytes);
  return {bytes->begin(), bytes->end()};
}

cv::Mat pixels_of(const Image& image) {
  return {image.height, image.width, CV_8UC(image.channels), const_cast<std::uint8_t*>(image.pixels.data())};
}

// Halves, which are made several times quicker than other sizes, and then the rest of the way.
cv::Mat light_pixels(const cv::Mat& pixels) {
  cv::Mat small = pixels;
  while (small.cols >= 2 * light_width) {
    cv::Mat half;
    cv::resize(small, half, {small.cols / 2, small.rows / 2}, 0, 0, cv::INTER_AREA);
    small = half;
  }
  if (small.cols <= light_width) return small;
  cv::Mat light;
  cv::resize(small, light, {light_width, small.rows * light_width / small.cols}, 0, 0, cv::INTER_LINEAR);
  return light;
}

ImageFeeds::Picture picture_in(ImageFeeds::Size size, const StreamFrame& frame) {
  const Image& image = *frame.image;
  ImageFeeds::Picture picture{frame.number, frame.captured, image.width, image.height, {}, 0};
  if (size == ImageFeeds::Size::full) {
    picture.jpeg = full_jpeg(image);
    picture.full_bytes = picture.jpeg.size();
  } else {
    const cv::Mat pixels = light_pixels(pixels_of(image));
    picture.jpeg = jpeg_of(pixels, light_quality);
    const double larger = static_cast<double>(image.width) * image.height / static_cast<double>(pixels.total());
    picture.full_bytes = static_cast<std::size_t>(full_to_light * larger * static_cast<double>(picture.jpeg.size()));
  }
  return picture;
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
  using Pictures = std::map<Size, std::shared_ptr<const Picture>>;
  // A frame, in each of the sizes in which it is wanted.
  struct Wanted {
    StreamFrame frame;
    std::uint64_t count;
    Pictures pictures;  // null: still to be made
    bool lacks_any() const {
      return std::ranges::any_of(pictures, [](const auto& entry) { return entry.second == nullptr; });
    }
  };

  // `waits`: somebody waits for a picture. `frames`: how many have come, of all streams.
  Feed(Streams& streams, const std::string& stream, std::uint64_t& frames, std::function<void()> waits)
      : frames_(frames),
        waits_(std::move(waits)),
        subscription_(streams.subscribe(stream, [this](const StreamFrame& frame) {
          if (!can_be_encoded(*frame.image)) return;
          newest_ = frame;
          ++count_;
          came_ = ++frames_;
          made_.clear();
          if (waits_since()) waits_();
        })) {}

  void add(std::uint64_t number, Receiver receiver) { looks_.emplace(number, Looking{std::move(receiver)}); }
  void want(std::uint64_t number, std::optional<Size> size) {
    looks_.at(number).wants = size;
    if (waits_since()) waits_();
  }
  // Whether nobody looks any more.
  bool remove(std::uint64_t number) {
    looks_.erase(number);
    return looks_.empty();
  }

  // After how many others the frame came that somebody waits for, if anybody does.
  std::optional<std::uint64_t> waits_since() const {
    const bool waiting = std::ranges::any_of(looks_, [this](const auto& entry) { return waits(entry.second); });
    return waiting ? std::optional(came_) : std::nullopt;
  }
  Wanted wanted() const {
    Wanted wanted{newest_, count_, {}};
    for (const auto& [number, look] : looks_) {
      if (!waits(look)) continue;
      const auto made = made_.find(*look.wants);
      wanted.pictures[*look.wants] = made == made_.end() ? nullptr : made->second;
    }
    return wanted;
  }
  void show(const Wanted& made) {
    if (made.count == count_) made_.insert(made.pictures.begin(), made.pictures.end());
    for (auto& [number, look] : looks_) {
      if (!look.wants || look.shown >= made.count || !made.pictures.contains(*look.wants)) continue;
      look.shown = made.count;
      look.show(made.pictures.at(*look.wants));
    }
  }

 private:
  struct Looking {
    Receiver show;
    std::optional<Size> wants = {};
    std::uint64_t shown = 0;
  };
  bool waits(const Looking& look) const { return look.wants && look.shown < count_; }

  std::uint64_t& frames_;
  std::function<void()> waits_;
  std::map<std::uint64_t, Looking> looks_;
  StreamFrame newest_;
  std::uint64_t came_ = 0;
  std::uint64_t count_ = 0;  // of the frames; 0: none has come
  Pictures made_;            // of the newest frame
  std::unique_ptr<Streams::Subscription> subscription_;
};

namespace {

void make_pictures(ImageFeeds::Feed::Wanted& wanted) {
  for (auto& [size, picture] : wanted.pictures) {
    if (!picture) picture = std::make_shared<ImageFeeds::Picture>(picture_in(size, wanted.frame));
  }
}

}  // namespace

ImageFeeds::ImageFeeds(Executor& executor, Streams& streams) : executor_(executor), streams_(streams) {}
ImageFeeds::~ImageFeeds() = default;

// One at a time, of all streams, so that the console takes one core at most of those that the cell works on. In the
// order in which they came: what a cell shows first of a frame goes first over a slow line.
Task<void> ImageFeeds::encode_what_waits() {
  while (const std::shared_ptr<Feed> feed = longest_waiting()) {
    const auto wanted = std::make_shared<Feed::Wanted>(feed->wanted());
    const std::function<void(const std::function<bool()>&)> work = [wanted](const auto&) { make_pictures(*wanted); };
    if (wanted->lacks_any()) co_await executor_.offload(work, encoding_cost);
    feed->show(*wanted);
  }
}

std::shared_ptr<ImageFeeds::Feed> ImageFeeds::longest_waiting() const {
  std::shared_ptr<Feed> longest;
  for (const auto& [stream, feed] : feeds_) {
    const std::optional<std::uint64_t> since = feed->waits_since();
    if (since && (!longest || *since < *longest->waits_since())) longest = feed;
  }
  return longest;
}

std::unique_ptr<ImageFeeds::Look> ImageFeeds::look(const std::string& stream, Receiver receiver) {
  std::shared_ptr<Feed>& feed = feeds_[stream];
  const auto waits = [this] {
    if (encoding_.done()) encoding_ = executor_.spawn(encode_what_waits());
  };
  if (!feed) feed = std::make_shared<Feed>(streams_, stream, frames_, waits);
  const std::uint64_t number = next_look_++;
  feed->add(number, std::move(receiver));
  return std::make_unique<Look>(*this, stream, number);
}

ImageFeeds::Look::Look(ImageFeeds& feeds, std::string stream, std::uint64_t number)
    : feeds_(feeds), stream_(std::move(stream)), number_(number) {}

void ImageFeeds::Look::want(std::optional<Size> size) { feeds_.feeds_.at(stream_)->want(number_, size); }

ImageFeeds::Look::~Look() {
  const auto feed = feeds_.feeds_.find(stream_);
  if (feed->second->remove(number_)) feeds_.feeds_.erase(feed);
}

}  // namespace pizarra::console
