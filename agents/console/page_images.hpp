#pragma once

// The images of one page, on lanes: connections of their own beside the page's. A lane carries one image at a time. So
// a lost packet holds one image back, and neither the images after it nor what the page and the console say.
//
//   PageImages images(executor, feeds, pulse);
//   images.add_lane(std::move(upgraded));      // the page has opened it
//   images.look("vision-colour");              // its newest image goes whenever a lane is free
//
// On a lane the page is told an image as binary: a line `(image STREAM NUMBER CAPTURED-US WIDTH HEIGHT)`, and the JPEG
// behind it. It answers `(drawn MS)`: for so long it had the image until it was drawn. `words` hears all else that it
// says on a lane, and answers whether that was understood.
//
// After each lost packet TCP sends less at a time, and a lane that carries an image now and then never gets that back.
// Sooner or later an image takes two round trips there. On a long line the page is then told `(renew)`: it closes that
// lane and opens another, which begins as quick as the first was.
//
// Bounds: 4 streams; 8 lanes; of a stream two to four images under way, as the round trip needs; 64 kB under way
// on all lanes together, or one larger image. Images are light (image_feed.hpp) until the line is known to carry full
// ones (picture_size.hpp).

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>

#include "agents/console/image_feed.hpp"
#include "agents/console/picture_size.hpp"
#include "agents/console/pulse.hpp"
#include "drivers/web/web_socket.hpp"
#include "lisp/datum.hpp"

namespace pizarra::console {

class PageImages {
 public:
  static constexpr std::size_t max_streams = 4;
  static constexpr std::size_t max_lanes = 8;
  static constexpr std::size_t max_under_way = 4;  // of a stream
  static constexpr std::size_t max_bytes_under_way = 64 << 10;

  using Words = std::function<bool(const Datum& form)>;
  // `pulse` measures the line to the page; all outlive this.
  PageImages(Executor& executor, ImageFeeds& feeds, const Pulse& pulse, Words words);
  PageImages(const PageImages&) = delete;
  PageImages& operator=(const PageImages&) = delete;
  ~PageImages();

  // False: it is one stream too many.
  bool look(const std::string& stream);
  void look_away(const std::string& stream);
  bool takes_lane() const { return lanes_.size() < max_lanes; }
  void add_lane(web::UpgradedSocket socket);

 private:
  static constexpr Duration longest_near = 50ms;  // a line that takes longer is long
  static constexpr Duration between_renewals = 500ms;
  struct Stream {
    std::shared_ptr<const ImageFeeds::Picture> newest;  // not sent yet
    Time sent{};                                        // the one before it
    std::unique_ptr<ImageFeeds::Look> look;
  };
  struct Lane {
    std::unique_ptr<web::WebSocket> socket;
    std::string stream = {};        // of the image that is under way; empty: none is
    PictureSize::Drawn image = {};  // it, and how long the one before it waited
  };

  void hear(Lane& lane, std::string_view message);
  void note_drawn(Lane& lane, Duration drawing);
  void renew_if_slow(Lane& lane, Duration line);
  void send_what_waits();
  void say_wishes();
  Lane* free_lane();
  std::pair<const std::string, Stream>* next_stream();
  std::size_t under_way(const std::string& stream) const;
  std::size_t most_under_way() const;
  std::size_t bytes_under_way() const;
  void send(Lane& lane, const std::string& name, Stream& stream);

  Executor& executor_;
  ImageFeeds& feeds_;
  const Pulse& pulse_;
  const Words words_;
  std::map<std::string, Stream> streams_;
  std::list<Lane> lanes_;
  PictureSize size_;
  Time renewed_{};  // when a lane was last
};

}  // namespace pizarra::console
