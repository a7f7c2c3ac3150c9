#include "blackboard/streams/shared_ring.hpp"

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace pizarra::streams {

namespace {

constexpr std::size_t slots = 4;
constexpr std::size_t word_bytes = sizeof(std::uint64_t);
constexpr std::uint64_t ring_mark = 0x312d656d61726670;  // says that it is one of ours
constexpr int seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_FUTURE_WRITE | F_SEAL_SEAL;
constexpr int tries = 4;

// A cache line before the slots, and one at the beginning of each.
constexpr std::size_t line_words = 8;
enum RingWord : std::size_t { mark, words_of_slot, written };
enum SlotWord : std::size_t { sequence, number, captured_us, width, height, channels, bytes };

std::size_t words_for(std::size_t image_bytes) {
  const std::size_t lines = (image_bytes + line_words * word_bytes - 1) / (line_words * word_bytes);
  return line_words + lines * line_words;
}

std::size_t slot_begin(std::uint64_t count, std::size_t slot_words) {
  return line_words + (count - 1) % slots * slot_words;
}

using Word = std::atomic_ref<std::uint64_t>;

void put(std::uint64_t* word, std::uint64_t value) { Word(*word).store(value, std::memory_order_relaxed); }
std::uint64_t get(std::uint64_t* word) { return Word(*word).load(std::memory_order_relaxed); }

void put_bytes(std::uint64_t* words, const std::vector<std::uint8_t>& from) {
  const std::size_t whole = from.size() / word_bytes;
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < whole; ++i) {
    std::memcpy(&word, from.data() + i * word_bytes, word_bytes);
    put(words + i, word);
  }
  const std::size_t left = from.size() % word_bytes;
  if (left == 0) return;
  std::memcpy(&word, from.data() + whole * word_bytes, left);
  put(words + whole, word);
}

void get_bytes(std::uint64_t* words, std::vector<std::uint8_t>& to) {
  const std::size_t whole = to.size() / word_bytes;
  for (std::size_t i = 0; i < whole; ++i) {
    const std::uint64_t word = get(words + i);
    std::memcpy(to.data() + i * word_bytes, &word, word_bytes);
  }
  const std::size_t left = to.size() % word_bytes;
  if (left == 0) return;
  const std::uint64_t word = get(words + whole);
  std::memcpy(to.data() + whole * word_bytes, &word, left);
}

}  // namespace

bool is_image(std::uint64_t width, std::uint64_t height, std::uint64_t channels, std::uint64_t bytes) {
  constexpr std::uint64_t longest_side = 1 << 16;
  return width <= longest_side && height <= longest_side && (channels == 1 || channels == 3) &&
         bytes <= max_image_bytes && width * height * channels == bytes;
}

SharedWords::~SharedWords() {
  if (words_ != nullptr) munmap(words_, bytes_);
}

Result<SharedRing> SharedRing::make(std::size_t largest_image) {
  const auto refused = [] { return fail("no-shared-memory", std::strerror(errno)); };
  const std::size_t slot_words = words_for(largest_image);
  const std::size_t size = (line_words + slots * slot_words) * word_bytes;
  File file(memfd_create("pizarra-stream", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!file || ftruncate(file.number(), static_cast<off_t>(size)) != 0) return refused();
  void* start = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file.number(), 0);
  if (start == MAP_FAILED) return refused();
  SharedWords words(start, size);
  put(words.at(mark), ring_mark);
  put(words.at(words_of_slot), slot_words);
  if (fcntl(file.number(), F_ADD_SEALS, seals) != 0) return refused();
  return SharedRing(std::move(file), std::move(words), largest_image);
}

void SharedRing::write(const StreamFrame& frame) {
  const Image& image = *frame.image;
  assert(image.pixels.size() <= largest_image_);
  const std::uint64_t count = ++written_;
  std::uint64_t* slot = words_.at(slot_begin(count, get(words_.at(words_of_slot))));
  put(slot + sequence, 2 * count - 1);
  std::atomic_thread_fence(std::memory_order_release);
  put(slot + number, frame.number);
  put(slot + captured_us, static_cast<std::uint64_t>(frame.captured.time_since_epoch().count()));
  put(slot + width, static_cast<std::uint64_t>(image.width));
  put(slot + height, static_cast<std::uint64_t>(image.height));
  put(slot + channels, static_cast<std::uint64_t>(image.channels));
  put(slot + bytes, image.pixels.size());
  put_bytes(slot + line_words, image.pixels);
  Word(slot[sequence]).store(2 * count, std::memory_order_release);
  Word(*words_.at(written)).store(count, std::memory_order_release);
}

Result<SharedRingView> SharedRingView::of(const File& file) {
  const auto refused = [](const char* why) { return fail("bad-ring", why); };
  struct stat about {};
  if (fstat(file.number(), &about) != 0) return refused("it is no memory");
  if ((fcntl(file.number(), F_GET_SEALS) & F_SEAL_SHRINK) == 0) return refused("it may shrink");
  const auto size = static_cast<std::size_t>(about.st_size);
  if (size < line_words * word_bytes) return refused("it is too short");
  void* start = mmap(nullptr, size, PROT_READ, MAP_SHARED, file.number(), 0);
  if (start == MAP_FAILED) return refused(std::strerror(errno));
  SharedWords words(start, size);
  const std::uint64_t slot_words = get(words.at(words_of_slot));
  const bool fits = slot_words >= line_words && slot_words <= words_for(max_image_bytes) &&
                    line_words + slots * slot_words == words.count();
  if (get(words.at(mark)) != ring_mark || !fits) return refused("it is not a ring of frames");
  return SharedRingView(std::move(words), slot_words);
}

std::optional<StreamFrame> SharedRingView::newest() {
  for (int i = 0; i < tries; ++i) {
    const std::uint64_t count = Word(*words_.at(written)).load(std::memory_order_acquire);
    if (count == read_) return std::nullopt;
    std::optional<StreamFrame> frame = copy(count);
    if (!frame) continue;
    read_ = count;
    return frame;
  }
  return std::nullopt;
}

// The image answered before, where nobody has kept it: memory that is there already costs less than the copying.
std::shared_ptr<Image> SharedRingView::unused_image() {
  const bool unused = image_ && image_.use_count() == 1;
  if (!unused) image_ = std::make_shared<Image>();
  // Whatever another thread did with it comes before its letting go.
  std::atomic_thread_fence(std::memory_order_acquire);
  return image_;
}

std::optional<StreamFrame> SharedRingView::copy(std::uint64_t count) {
  std::uint64_t* slot = words_.at(slot_begin(count, slot_words_));
  if (Word(slot[sequence]).load(std::memory_order_acquire) != 2 * count) return std::nullopt;
  const std::uint64_t size = get(slot + bytes);
  if (!is_image(get(slot + width), get(slot + height), get(slot + channels), size)) return std::nullopt;
  if (size > (slot_words_ - line_words) * word_bytes) return std::nullopt;
  const std::shared_ptr<Image> image = unused_image();
  image->width = static_cast<int>(get(slot + width));
  image->height = static_cast<int>(get(slot + height));
  image->channels = static_cast<int>(get(slot + channels));
  image->pixels.resize(size);
  get_bytes(slot + line_words, image->pixels);
  const StreamFrame frame{get(slot + number), Time(Duration(get(slot + captured_us))), image};
  std::atomic_thread_fence(std::memory_order_acquire);
  if (get(slot + sequence) != 2 * count) return std::nullopt;
  return frame;
}

}  // namespace pizarra::streams
