#pragma once

// Keeps what the cell's eyes see, two pictures a second of each stream that the page shows, for the page to look back
// at: whether a page is open or not.
//
//   PictureKeeper keeper({executor, streams, std::move(board), store, [](const Failure& why) { ... }});
//
// It subscribes to the streams that are announced on its board. A picture that comes while the one before is being
// written is not kept. Where none can be kept it says so once, and goes on trying.

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "agents/console/picture_store.hpp"
#include "blackboard/board.hpp"
#include "blackboard/stream.hpp"

namespace pizarra::console {

class PictureKeeper {
 public:
  static constexpr Duration interval = 500ms;

  struct Setup {
    Executor& executor;
    Streams& streams;
    std::unique_ptr<Board> board;
    PictureStore& store;  // outlives the keeper, as do executor and streams
    std::function<void(const Failure&)> trouble;
  };

  explicit PictureKeeper(Setup setup);
  PictureKeeper(const PictureKeeper&) = delete;
  PictureKeeper& operator=(const PictureKeeper&) = delete;
  ~PictureKeeper();

 private:
  struct Kept {
    Time last{};
    Job keeping;
    std::unique_ptr<Streams::Subscription> subscription;
  };

  Task<void> follow_streams();
  void begin(const std::string& stream);
  void take(const std::string& stream, Kept& kept, const StreamFrame& frame);
  Task<void> keep(std::string stream, StreamFrame frame);
  void say_trouble(const Failure& failure);

  Setup setup_;
  bool troubled_ = false;
  std::map<std::string, std::unique_ptr<Kept>> kept_;
  Job following_;
};

}  // namespace pizarra::console
