#pragma once

// Pictures of what the cameras saw, kept in a folder of their own for as long as there is room: the oldest goes first.
// Each is a file, STREAM/CAPTURED-US_NUMBER_WIDTHxHEIGHT.jpg, which any viewer shows. A store that is opened again
// knows what was kept before.
//
//   auto store = PictureStore::open(executor, folder, PictureStore::usual_bytes);
//   Result<void> kept = co_await (*store)->keep("vision-colour", frame);
//   Result<PictureStore::Picture> then = co_await (*store)->find("vision-colour", moment);
//
// It takes a quarter of what is free on the disk at most, so that a journal beside it has room too. Files are written
// and read away from the agents' thread. One store at a time works in a folder.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "blackboard/stream.hpp"
#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra::console {

struct KeptPicture {
  std::string stream;
  Time captured{};
  std::uint64_t number = 0;
  int width = 0;
  int height = 0;
  std::string file;
};
// The pictures in such a folder, the oldest first; another process may be at work there.
std::vector<KeptPicture> kept_pictures(const std::string& folder);

class PictureStore {
 public:
  static constexpr std::uintmax_t usual_bytes = 1'000'000'000;
  static constexpr std::size_t max_streams = 8;
  // A picture that is older than this is none of that moment.
  static constexpr Duration longest_gap = 10s;

  struct Picture {
    std::uint64_t number = 0;
    Time captured{};
    int width = 0;
    int height = 0;
    std::string jpeg;
  };

  // Failures: cannot-write, in-use.
  static Result<std::unique_ptr<PictureStore>> open(Executor& executor, const std::string& folder,
                                                    std::uintmax_t most_bytes);
  PictureStore(const PictureStore&) = delete;
  PictureStore& operator=(const PictureStore&) = delete;
  ~PictureStore();

  // Failures: bad-stream, too-many, bad-image, cannot-write.
  Task<Result<void>> keep(std::string stream, StreamFrame frame);
  // The newest that was captured until then. Failure: no-picture.
  Task<Result<Picture>> find(std::string stream, Time moment) const;
  std::uintmax_t bytes() const { return bytes_; }

 private:
  struct Entry {
    std::string file;
    std::uint64_t number = 0;
    int width = 0;
    int height = 0;
    std::uintmax_t bytes = 0;
  };
  using Stream = std::map<Time, Entry>;

  PictureStore(Executor& executor, std::string folder, int lock);
  void read_what_is_kept();
  void add(const std::string& stream, Time captured, Entry entry);
  void remove_oldest();

  Executor& executor_;
  const std::string folder_;
  const int lock_;  // an open file, locked for as long as this lives
  std::uintmax_t most_bytes_ = 0;
  std::uintmax_t bytes_ = 0;
  std::map<std::string, Stream> streams_;
};

}  // namespace pizarra::console
