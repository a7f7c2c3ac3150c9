#include "blackboard/cluster/cluster_log.hpp"

#include <fmt/format.h>

namespace pizarra::cluster {

ClusterLog::ClusterLog(std::shared_ptr<KeyValues> key_values, std::shared_ptr<KeyValues> reading, LogKeys keys,
                       EpochValue epoch, std::uint64_t head, std::string path, const LogWeight& weight)
    : key_values_(std::move(key_values)),
      reading_(std::move(reading)),
      keys_(std::move(keys)),
      epoch_(std::move(epoch)),
      path_(std::move(path)),
      space_(std::make_shared<LogSpace>(weight)),
      head_(head) {}

Result<std::vector<journal::RememberedReply>> ClusterLog::recover(store::Store& store) {
  FollowedLog followed(*key_values_, keys_, store, {});
  const Result<void> whole = followed.follow_to(head_);
  if (!whole) return fail(whole);
  return followed.replies();
}

Result<bool> ClusterLog::stands(const std::string& text) {
  const Result<std::optional<std::string>> standing = get(*key_values_, keys_.entry(head_ + 1));
  if (!standing) return fail(standing);
  if (!*standing) return false;
  if (**standing == text) return true;
  deposed_ = Failure{"deposed", fmt::format("another board wrote entry {} of {}", head_ + 1, path_), {}, {}};
  return fail(*deposed_);
}

Result<void> ClusterLog::append(const journal::JournalGroup& group, bool) {
  if (deposed_) return fail(*deposed_);
  const std::string text = text_of(head_ + 1, epoch_.number, group);
  constexpr std::size_t largest_entry = LogSpace::largest_entry;
  if (text.size() > largest_entry) {
    return fail("journal-full",
                fmt::format("{} takes no entry of {} bytes, {} at most", path_, text.size(), largest_entry));
  }
  if (in_doubt_) {
    const Result<bool> written = stands(text);
    if (!written) return fail(written);
    in_doubt_ = false;
    if (*written) {
      is_written(text);
      return {};
    }
  }
  in_doubt_ = true;
  const Result<KeyValues::Reply> put = key_values_->transact(
      {.compares = {{keys_.epoch(), cluster::text_of(epoch_)}, {keys_.head(), fmt::format("{}", head_)}},
       .puts = {{keys_.entry(head_ + 1), text}, {keys_.head(), fmt::format("{}", head_ + 1)}}},
      patience);
  if (!put) return fail(put);
  // Where it did not go through, an earlier attempt may have, late.
  const Result<bool> written = put->succeeded ? Result<bool>(true) : stands(text);
  if (!written) return fail(written);
  in_doubt_ = false;
  if (*written) {
    is_written(text);
    return {};
  }
  deposed_ = Failure{"deposed", "another board leads the cell now, in " + path_, {}, {}};
  return fail(*deposed_);
}

void ClusterLog::is_written(const std::string& text) {
  ++head_;
  space_->wrote(text.size());
}

journal::JournalRoom ClusterLog::room() { return space_->room(path_); }

Result<journal::PlayedBack> ClusterLog::read(store::Store& store, const Moment& until) const {
  Result<journal::PlayedBack> played = read_log(*reading_, keys_, store, until);
  if (played) {
    played->lacks =
        Failure{"gap",
                "the log of boards that take over has only what is durable, and this board keeps no past of its own",
                {},
                {}};
  }
  return played;
}

Result<journal::PlayedBack> read_log(KeyValues& key_values, const LogKeys& keys, store::Store& store,
                                     const Moment& until) {
  FollowedLog followed(key_values, keys, store, until);
  while (true) {
    const Result<std::size_t> came = followed.follow();
    if (!came) return fail(came);
    if (*came == 0) return journal::PlayedBack{followed.end(), followed.later()};
  }
}

}  // namespace pizarra::cluster
