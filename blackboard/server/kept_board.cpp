#include "blackboard/server/kept_board.hpp"

#include <algorithm>

#include "blackboard/store/store.hpp"

namespace pizarra::server {

namespace {

// More revisions and facts than may wait to be written: a crash loses those, and clients may know their numbers.
constexpr std::uint64_t may_be_lost = std::uint64_t{1} << 22;

}  // namespace

Result<void> KeptBoard::begin(const std::shared_ptr<journal::JournalFile>& file) {
  // Leases are numbered from the time, so that one of an earlier life is not taken for one of this.
  auto store = std::make_unique<store::Store>(static_cast<LeaseId>(executor_.now().time_since_epoch().count()));
  if (file != nullptr) {
    const Result<void> recovered = recover(file, *store);
    if (!recovered) return recovered;
  }
  board_ = std::make_unique<memory::MemoryBoard>(executor_, std::move(store));
  if (journal_ != nullptr) board_->set_journal([this](std::string_view line) { journal_->append(line); });
  board_->resume();
  return {};
}

void KeptBoard::lead(std::unique_ptr<store::Store> store, LeaseId first_lease,
                     std::vector<journal::RememberedReply> remembered, const std::shared_ptr<journal::Log>& log,
                     store::JournalSink all) {
  remembered_ = std::move(remembered);
  store->begin_leases_at(first_lease);
  journal_ = std::make_unique<journal::JournalWriter>(executor_, log);
  journal_->on_failure = on_journal_;
  board_ = std::make_unique<memory::MemoryBoard>(executor_, std::move(store));
  board_->set_journal_of_durable([this](std::string_view line) { journal_->append(line); });
  board_->set_journal(std::move(all));
  board_->resume();
}

Result<void> KeptBoard::recover(const std::shared_ptr<journal::JournalFile>& file, store::Store& store) {
  Result<std::vector<journal::RememberedReply>> remembered = file->recover(store);
  if (!remembered) return fail(remembered);
  remembered_ = std::move(*remembered);
  const bool has_lived = store.revision() > 0;
  if (has_lived) store.restore_counters(store.revision() + may_be_lost, store.next_fact() + may_be_lost);
  journal_ = std::make_unique<journal::JournalWriter>(executor_, file);
  journal_->on_failure = on_journal_;
  if (on_journal_ && journal_->failure()) on_journal_(journal_->failure());
  return {};
}

Time first_moment(const std::function<Time()>& wall_clock, const std::string& journal, journal::Disk& disk) {
  Time end{};
  if (!journal.empty() && disk.status(journal)) {
    // One that cannot be read is reported by whoever goes on from it.
    const Result<journal::LineStart> last = journal::end_of_journal(journal, disk);
    if (last) end = last->when;
  }
  return std::max(wall_clock(), end);
}

}  // namespace pizarra::server
