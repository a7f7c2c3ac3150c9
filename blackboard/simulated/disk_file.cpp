#include "blackboard/simulated/disk_file.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::simulated {

void DiskFile::write(std::int64_t offset, std::string_view text) {
  const auto begin = static_cast<std::size_t>(offset);
  const std::size_t end = begin + text.size();
  const std::string before = begin < data.size() ? data.substr(begin, text.size()) : std::string();
  unflushed.push_back({offset, before, data.size()});
  if (end > data.size()) data.resize(end, '\0');
  std::ranges::copy(text, data.begin() + offset);
}

void DiskFile::cut(std::int64_t bytes) {
  const auto end = static_cast<std::size_t>(bytes);
  if (end < data.size()) unflushed.push_back({bytes, data.substr(end), data.size()});
  data.resize(end, '\0');
}

void DiskFile::lose_some(Random& random) {
  for (auto before = unflushed.rbegin(); before != unflushed.rend(); ++before) {
    if (random.below(2) == 0) continue;
    const std::size_t end = static_cast<std::size_t>(before->offset) + before->text.size();
    if (data.size() < end) data.resize(end, '\0');
    std::ranges::copy(before->text, data.begin() + before->offset);
    // The bytes that a lost write added are gone, unless a later write behind them lasts.
    const bool is_last = data.size() > before->bytes;
    if (is_last && random.below(2) == 0) data.resize(std::max(end, before->bytes));
  }
  unflushed.clear();
}

void DiskFile::forget_its_users() {
  locked = false;
  shared = 0;
  reserved = false;
  exclusive = false;
  std::ranges::move(index, std::back_inserter(former_indexes));
  index.clear();
  index_users = 0;
  index_shared = {};
  index_exclusive = {};
}

}  // namespace pizarra::simulated
