#pragma once

// A stream's newest frames in memory that publisher and subscribers of one machine share, so that a frame is written
// once however many read it.
//
//   Result<SharedRing> ring = SharedRing::make(320 * 240 * 3);     // bytes of the largest image it takes
//   ring->write(frame);
//   Result<SharedRingView> view = SharedRingView::of(std::move(file));   // a duplicate of ring->file()
//   if (std::optional<StreamFrame> frame = view->newest()) ...
//
// The memory has no name in any file system and is gone with the last process that has it, however that ended. It is
// sealed: subscribers cannot write into it, and nobody can shrink it under them.
//
// Each slot has a sequence number (a seqlock): odd while frame n is written, 2n when frame n stands there. A reader
// that finds another number after copying than before has read a mixture, and reads again. The writer never waits.
// Everything in the memory is read and written as atomic words, so that reading a mixture is defined, and harmless.

#include <cstdint>
#include <optional>

#include "blackboard/stream.hpp"
#include "blackboard/streams/file.hpp"
#include "lisp/result.hpp"

namespace pizarra::streams {

// Of one image.
inline constexpr std::size_t max_image_bytes = 64 << 20;

// Whether an image of these numbers may exist, wherever they come from.
bool is_image(std::uint64_t width, std::uint64_t height, std::uint64_t channels, std::uint64_t bytes);

// Shared memory as words.
class SharedWords {
 public:
  SharedWords() = default;
  SharedWords(void* start, std::size_t bytes) : words_(static_cast<std::uint64_t*>(start)), bytes_(bytes) {}
  SharedWords(SharedWords&& other) noexcept
      : words_(std::exchange(other.words_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  SharedWords& operator=(SharedWords&& other) noexcept {
    std::swap(words_, other.words_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~SharedWords();
  std::uint64_t* at(std::size_t word) const { return words_ + word; }
  std::size_t count() const { return bytes_ / sizeof(std::uint64_t); }

 private:
  std::uint64_t* words_ = nullptr;
  std::size_t bytes_ = 0;
};

class SharedRing {
 public:
  // Failure no-shared-memory.
  static Result<SharedRing> make(std::size_t largest_image);

  // An image that does not fit is a bug of the caller.
  void write(const StreamFrame& frame);
  std::size_t largest_image() const { return largest_image_; }
  const File& file() const { return file_; }

 private:
  SharedRing(File file, SharedWords words, std::size_t largest_image)
      : file_(std::move(file)), words_(std::move(words)), largest_image_(largest_image) {}
  File file_;
  SharedWords words_;
  std::size_t largest_image_;
  std::uint64_t written_ = 0;
};

class SharedRingView {
 public:
  // Failure bad-ring.
  static Result<SharedRingView> of(const File& file);

  // The newest frame, when it is newer than the one answered before. Nothing either where the writer overtook the
  // reading several times: there is a newer one then, and word of it.
  std::optional<StreamFrame> newest();

 private:
  SharedRingView(SharedWords words, std::size_t slot_words) : words_(std::move(words)), slot_words_(slot_words) {}
  std::shared_ptr<Image> unused_image();
  std::optional<StreamFrame> copy(std::uint64_t count);
  SharedWords words_;
  std::size_t slot_words_;
  std::uint64_t read_ = 0;
  std::shared_ptr<Image> image_;
};

}  // namespace pizarra::streams
