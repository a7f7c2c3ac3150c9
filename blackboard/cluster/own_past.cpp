#include "blackboard/cluster/own_past.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

namespace pizarra::cluster {

namespace files = std::filesystem;

namespace {

constexpr const char* ending = ".journal";

std::string journal_of(const PastChoices& choices, const std::string& cell, std::uint64_t epoch) {
  return fmt::format("{}/{}-{:06}{}", choices.folder, cell, epoch, ending);
}

// CELL-DIGITS.journal alone: another cell may be called CELL-2.
bool is_journal_of(const std::string& cell, const std::string& name) {
  const std::string start = cell + "-";
  const std::size_t frame = start.size() + std::string_view(ending).size();
  if (name.size() <= frame || !name.starts_with(start) || !name.ends_with(ending)) return false;
  return std::ranges::all_of(std::string_view(name).substr(start.size(), name.size() - frame),
                             [](char c) { return '0' <= c && c <= '9'; });
}

// The journals of a cell's terms, oldest first.
Result<std::vector<std::string>> journals_in(const PastChoices& choices, const std::string& cell) {
  std::error_code refused;
  files::create_directories(choices.folder, refused);
  std::vector<std::string> paths;
  for (const files::directory_entry& entry : files::directory_iterator(choices.folder, refused)) {
    const std::string name = entry.path().filename().string();
    if (is_journal_of(cell, name)) paths.push_back(choices.folder + "/" + name);
  }
  if (refused) return fail("journal-file", "cannot keep a past in " + choices.folder + ": " + refused.message());
  std::ranges::sort(paths);
  return paths;
}

std::uintmax_t bytes_of(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = files::file_size(path, unknown);
  return unknown ? 0 : bytes;
}

// The files that stay have the space that a living board sets aside back.
void let_go_of_the_oldest(std::vector<std::string>& paths, const journal::History& history) {
  std::uintmax_t bytes = 0;
  for (const std::string& path : paths) {
    journal::this_disk().remove(path + "-reserve");
    bytes += bytes_of(path);
  }
  while (!paths.empty() && (paths.size() >= OwnPast::most_terms || bytes > history.bytes)) {
    bytes -= bytes_of(paths.front());
    journal::remove_journal(paths.front());
    paths.erase(paths.begin());
  }
}

Failure gap(const std::optional<Revision>& before, const std::optional<Revision>& after) {
  const std::string from = before ? fmt::format("after revision {}", *before) : std::string();
  const std::string to = after ? fmt::format("before revision {}", *after) : std::string();
  return {"gap",
          fmt::format("this board has nothing of what was not durable {}{}{}: it did not lead then, or did not keep it",
                      from, before && after ? " and " : "", to),
          after ? to_datum(*after) : Datum(),
          {}};
}

}  // namespace

// Written to is the term that has begun; read are all of them.
class OwnPast::Terms : public journal::Log {
 public:
  Terms(std::shared_ptr<journal::JournalFile> file, std::vector<std::string> earlier,
        std::shared_ptr<const journal::Log> shared)
      : file_(std::move(file)), earlier_(std::move(earlier)), shared_(std::move(shared)) {}

  const std::string& path() const override { return file_->path(); }
  Result<std::vector<journal::RememberedReply>> recover(store::Store& store) override { return file_->recover(store); }
  Result<void> append(const journal::JournalGroup& group, bool may_spend) override {
    return file_->append(group, may_spend);
  }
  journal::JournalRoom room() override { return file_->room(); }
  Result<std::size_t> compact(Time now) override { return file_->compact(now); }
  Result<journal::PlayedBack> read(store::Store& store, const Moment& until) const override;

  void end() { ended_ = true; }
  bool has_ended() const { return ended_; }

 private:
  const std::shared_ptr<journal::JournalFile> file_;
  const std::vector<std::string> earlier_;
  const std::shared_ptr<const journal::Log> shared_;
  std::atomic<bool> ended_ = false;
};

Result<journal::PlayedBack> OwnPast::Terms::read(store::Store& store, const Moment& until) const {
  std::optional<Revision> before;
  std::optional<Revision> after;
  std::vector<std::string> paths = earlier_;
  paths.push_back(file_->path());
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    const Result<journal::LineStart> end = journal::end_of_journal(*path);
    if (!end) return fail(end);
    const bool goes_on = path == paths.rbegin() && !ended_;
    if (!goes_on && until.revision > end->revision && until.time > end->when) {
      before = end->revision;
      break;
    }
    Result<journal::PlayedBack> played = journal::read_journal(*path, store, until);
    const bool begins_later = !played && played.error().symbol == "forgotten";
    if (!begins_later) return played;
    after = static_cast<Revision>(played.error().subject.integer());
  }
  Result<journal::PlayedBack> played = shared_->read(store, until);
  if (played) played->lacks = gap(before, after);
  return played;
}

OwnPast::OwnPast(Executor& executor, std::shared_ptr<Terms> terms)
    : terms_(std::move(terms)), writer_(executor, terms_) {}

Result<std::unique_ptr<OwnPast>> OwnPast::begin(Executor& executor, const PastChoices& choices, const std::string& cell,
                                                std::uint64_t epoch, const store::Store& store,
                                                const journal::LineStart& from,
                                                std::shared_ptr<const journal::Log> shared) {
  Result<std::vector<std::string>> earlier = journals_in(choices, cell);
  if (!earlier) return fail(earlier);
  const std::string path = journal_of(choices, cell, epoch);
  if (!earlier->empty() && earlier->back() >= path) {
    return fail("exists", fmt::format("{} has the past of another log of {}: move it, or name another folder",
                                      choices.folder, cell));
  }
  let_go_of_the_oldest(*earlier, choices.history);
  Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open(path, choices.history);
  if (!file) return fail(file);
  const Result<void> begun = (*file)->begin_with(store, from);
  if (!begun) return fail(begun);
  auto terms = std::make_shared<Terms>(std::move(*file), std::move(*earlier), std::move(shared));
  return std::unique_ptr<OwnPast>(new OwnPast(executor, std::move(terms)));
}

void OwnPast::add(std::string_view line) {
  if (terms_->has_ended()) return;
  // A line that is missing would make nonsense of those behind it.
  const Result<void> room = writer_.check_room(journal::JournalWriter::Change::passing, line.size());
  if (room) return writer_.append(line);
  terms_->end();
  if (on_end) on_end(room.error());
}

}  // namespace pizarra::cluster
