#pragma once

// Image streams as JPEGs. Each frame is encoded once for all pages, away from the agents' thread, and only in the sizes
// that somebody wants then. Frames of several streams are encoded one at a time, in the order in which they came. Only
// the newest frame of a stream is encoded: a frame that comes meanwhile replaces the one that waits. A page on a slow
// line gets a light picture: 240 px wide at most, and of less quality.
//
//   ImageFeeds feeds(executor, streams);
//   auto look = feeds.look("vision-colour", [](const std::shared_ptr<const ImageFeeds::Picture>& picture) { ... });
//   look->want(ImageFeeds::Size::light);
//
// A stream is subscribed to while somebody looks. The feeds outlive the looks, and the streams the feeds.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "blackboard/stream.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra::console {

// Grey or in colours, and as large as it says.
bool can_be_encoded(const Image& image);
// Of the size and quality that a page on a quick line gets.
std::string full_jpeg(const Image& image);

class ImageFeeds {
 public:
  struct Picture {
    std::uint64_t number = 0;
    Time captured{};
    int width = 0;
    int height = 0;
    std::string jpeg;
    std::size_t full_bytes = 0;  // of the full picture of that frame; of a light one, what it is likely to take at most
  };
  enum class Size : std::uint8_t { full, light };
  using Receiver = std::function<void(const std::shared_ptr<const Picture>&)>;

  class Feed;
  // Destroying it ends the look.
  class Look {
   public:
    Look(ImageFeeds& feeds, std::string stream, std::uint64_t number);
    Look(const Look&) = delete;
    Look& operator=(const Look&) = delete;
    ~Look();
    // The size in which it is shown each picture from the newest on; none: it can take none. It begins with none.
    void want(std::optional<Size> size);

   private:
    ImageFeeds& feeds_;
    std::string stream_;
    std::uint64_t number_;
  };

  ImageFeeds(Executor& executor, Streams& streams);
  ImageFeeds(const ImageFeeds&) = delete;
  ImageFeeds& operator=(const ImageFeeds&) = delete;
  ~ImageFeeds();

  std::unique_ptr<Look> look(const std::string& stream, Receiver receiver);

 private:
  Task<void> encode_what_waits();
  // Null where none waits.
  std::shared_ptr<Feed> longest_waiting() const;

  Executor& executor_;
  Streams& streams_;
  std::map<std::string, std::shared_ptr<Feed>> feeds_;
  std::uint64_t frames_ = 0;  // that have come, of all streams
  std::uint64_t next_look_ = 1;
  Job encoding_;
};

}  // namespace pizarra::console
