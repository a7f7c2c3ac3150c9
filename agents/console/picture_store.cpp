#include "agents/console/picture_store.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

#include "agents/console/image_feed.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::console {

namespace {

namespace files = std::filesystem;

using Work = std::function<void(const std::function<bool()>&)>;

constexpr Duration writing_cost = 5ms;
constexpr Duration reading_cost = 2ms;
constexpr std::size_t longest_name = 64;
constexpr const char* part = ".part";

// A name of a folder: what others announce leads to no place elsewhere.
bool is_plain(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-'; };
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, plain);
}

Failure not_written(const std::string& path) {
  const std::string why = std::strerror(errno);
  return {"cannot-write", fmt::format("{} cannot be written: {}", text_of_bytes(path), why), {}, {}};
}

// Whole, or not at all.
bool write_file(const std::string& path, const std::string& bytes) {
  const std::string half = path + part;
  std::ofstream out(half, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (out.good() && std::rename(half.c_str(), path.c_str()) == 0) return true;
  const int why = errno;
  std::remove(half.c_str());
  errno = why;
  return false;
}

// What was being written when a console died.
void remove_halves(const std::string& folder) {
  std::error_code error;
  for (const auto& file : files::directory_iterator(folder, error)) {
    if (file.path().extension() == part) files::remove(file.path(), error);
  }
}

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Named as keep() names it.
std::optional<KeptPicture> picture_in(const files::path& file, const std::string& stream) {
  KeptPicture kept{.stream = stream, .file = file.string()};
  long long captured = 0;
  unsigned long long number = 0;
  const std::string name = file.filename().string();
  const int read = std::sscanf(name.c_str(), "%lld_%llu_%dx%d.jpg", &captured, &number, &kept.width, &kept.height);
  if (read != 4 || file.extension() != ".jpg") return std::nullopt;
  kept.captured = Time(Duration(captured));
  kept.number = number;
  return kept;
}

}  // namespace

std::vector<KeptPicture> kept_pictures(const std::string& folder) {
  std::vector<KeptPicture> pictures;
  std::error_code error;
  std::size_t streams = 0;
  for (const auto& stream : files::directory_iterator(folder, error)) {
    const std::string name = stream.path().filename().string();
    if (!stream.is_directory(error) || !is_plain(name) || ++streams > PictureStore::max_streams) continue;
    for (const auto& file : files::directory_iterator(stream.path(), error)) {
      if (std::optional<KeptPicture> kept = picture_in(file.path(), name)) pictures.push_back(std::move(*kept));
    }
  }
  std::ranges::sort(pictures, {}, &KeptPicture::captured);
  return pictures;
}

Result<std::unique_ptr<PictureStore>> PictureStore::open(Executor& executor, const std::string& folder,
                                                         std::uintmax_t most_bytes) {
  std::error_code error;
  files::create_directories(folder, error);
  const std::string lock_file = folder + "/lock";
  const int lock = ::open(lock_file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock < 0) return fail(not_written(folder));
  std::unique_ptr<PictureStore> store(new PictureStore(executor, folder, lock));
  if (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    return fail("in-use", fmt::format("another console keeps its pictures in {}", text_of_bytes(folder)));
  }
  store->read_what_is_kept();
  const files::space_info space = files::space(folder, error);
  // Where the disk does not say how full it is, what was asked for holds.
  const std::uintmax_t quarter = error ? most_bytes : (space.available + store->bytes_) / 4;
  store->most_bytes_ = std::min(most_bytes, quarter);
  store->remove_oldest();
  return store;
}

PictureStore::PictureStore(Executor& executor, std::string folder, int lock)
    : executor_(executor), folder_(std::move(folder)), lock_(lock) {}

PictureStore::~PictureStore() { close(lock_); }

void PictureStore::read_what_is_kept() {
  std::error_code error;
  for (const KeptPicture& kept : kept_pictures(folder_)) {
    Entry entry{kept.file, kept.number, kept.width, kept.height, files::file_size(kept.file, error)};
    add(kept.stream, kept.captured, std::move(entry));
  }
  for (const auto& [name, stream] : streams_) remove_halves(folder_ + "/" + name);
}

void PictureStore::add(const std::string& stream, Time captured, Entry entry) {
  const std::uintmax_t bytes = entry.bytes;
  if (streams_[stream].emplace(captured, std::move(entry)).second) bytes_ += bytes;
}

void PictureStore::remove_oldest() {
  while (bytes_ > most_bytes_) {
    Stream* oldest = nullptr;
    for (auto& [name, stream] : streams_) {
      if (!stream.empty() && (oldest == nullptr || stream.begin()->first < oldest->begin()->first)) oldest = &stream;
    }
    if (oldest == nullptr) return;
    const Entry& entry = oldest->begin()->second;
    std::remove(entry.file.c_str());
    bytes_ -= entry.bytes;
    oldest->erase(oldest->begin());
  }
}

Task<Result<void>> PictureStore::keep(std::string stream, StreamFrame frame) {
  if (!is_plain(stream)) co_return fail("bad-stream", "the name of a stream is letters, digits and hyphens");
  if (!can_be_encoded(*frame.image)) co_return fail("bad-image", "there is no picture in it");
  const bool is_new = !streams_.contains(stream);
  if (is_new && streams_.size() >= max_streams) co_return fail("too-many", "too many streams are kept");
  Entry entry{{}, frame.number, frame.image->width, frame.image->height};
  const std::string folder = folder_ + "/" + stream;
  std::error_code error;
  if (is_new) files::create_directory(folder, error);
  streams_[stream];
  entry.file = fmt::format("{}/{}_{}_{}x{}.jpg", folder, frame.captured.time_since_epoch().count(), frame.number,
                           entry.width, entry.height);
  struct Written {
    std::uintmax_t bytes = 0;
    std::optional<Failure> failure;
  };
  const auto written = std::make_shared<Written>();
  const Work work = [written, file = entry.file, image = frame.image](const std::function<bool()>&) {
    const std::string jpeg = full_jpeg(*image);
    written->bytes = jpeg.size();
    if (!write_file(file, jpeg)) written->failure = not_written(file);
  };
  co_await executor_.offload(work, writing_cost);
  if (written->failure) co_return fail(*written->failure);
  entry.bytes = written->bytes;
  add(stream, frame.captured, std::move(entry));
  remove_oldest();
  co_return {};
}

Task<Result<PictureStore::Picture>> PictureStore::find(std::string stream, Time moment) const {
  const Failure none{"no-picture", "no picture of that moment is kept", {}, {}};
  const auto kept = streams_.find(stream);
  if (kept == streams_.end()) co_return fail(none);
  const auto after = kept->second.upper_bound(moment);
  if (after == kept->second.begin()) co_return fail(none);
  const auto& [captured, entry] = *std::prev(after);
  if (captured < moment - longest_gap) co_return fail(none);
  const auto picture = std::make_shared<Picture>();
  picture->number = entry.number;
  picture->captured = captured;
  picture->width = entry.width;
  picture->height = entry.height;
  const Work work = [picture, file = entry.file](const std::function<bool()>&) { picture->jpeg = read_file(file); };
  co_await executor_.offload(work, reading_cost);
  if (picture->jpeg.empty()) co_return fail(none);
  co_return std::move(*picture);
}

}  // namespace pizarra::console
