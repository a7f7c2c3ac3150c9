#include "blackboard/journal/journal_writer.hpp"

#include <utility>

namespace pizarra {

namespace {

constexpr Duration not_waited_for = 100ms;
constexpr Duration try_again_after = 250ms;
constexpr Duration longest_disk = 20ms;  // that company is waited for in proportion to
constexpr std::size_t compaction_bytes = 256 << 10;
constexpr std::size_t written_at_once_bytes = 1 << 20;

}  // namespace

JournalWriter::JournalWriter(Executor& executor, std::shared_ptr<JournalFile> file)
    : executor_(executor),
      file_(std::move(file)),
      room_(file_->room()),
      failure_(lack_of_room()),
      due_(executor),
      job_(executor.spawn(write_groups())) {}

JournalWriter::~JournalWriter() {
  if (timer_ != 0) executor_.cancel(timer_);
  job_ = Job();
  if (work_ != nullptr) {
    work_->ended.wait(false);
    // Nobody waits any more for what cannot be written now.
    if (!work_->written) work_->written = file_->append(work_->group);
    if (!work_->written) return;
  }
  if (!pending_.lines.empty()) work_ = nullptr, take_pending(), work_->written = file_->append(work_->group);
}

void JournalWriter::append(std::string_view line) {
  pending_.lines += line;
  pending_.lines += '\n';
  ++position_;
  if (!failure_ && pending_.bytes() >= written_at_once_bytes) due_.set();
  if (timer_ != 0) return;
  timer_ = executor_.call_at(executor_.now() + not_waited_for, [this] {
    timer_ = 0;
    due_.set();
  });
}

void JournalWriter::remember(const RememberedReply& reply) { pending_.replies += reply_line(reply); }

void JournalWriter::keep() {
  if (std::exchange(pending_.durable, true)) return;
  if (timer_ != 0) executor_.cancel(timer_);
  timer_ = executor_.call_at(executor_.now() + disk_takes_ / 8, [this] {
    timer_ = 0;
    due_.set();
  });
}

std::optional<Failure> JournalWriter::lack_of_room() const {
  if (room_ > 0) return std::nullopt;
  return Failure{"journal-full", file_->path() + ": the disk is full", {}, {}};
}

Result<void> JournalWriter::check_room(bool durable, std::size_t bytes) const {
  if (durable && failure_) return fail(*failure_);
  const std::size_t under_way = work_ == nullptr ? 0 : work_->group.bytes();
  if (under_way + pending_.bytes() + bytes <= (failure_ ? max_waiting_bytes : room_)) return {};
  return fail("journal-full", "more waits to be written to " + file_->path() + " than is allowed to wait");
}

Task<void> JournalWriter::write_groups() {
  while (true) {
    std::optional<Time> again;
    if (failure_) again = executor_.now() + try_again_after;
    co_await due_.wait(again);
    due_.reset();
    if (work_ == nullptr) take_pending();
    co_await write_group();
    co_await compact();
  }
}

void JournalWriter::take_pending() {
  work_ = std::make_shared<Work>();
  work_->file = file_;
  work_->group = std::exchange(pending_, {});
  work_->last = position_;
}

Task<void> JournalWriter::write_group() {
  const std::shared_ptr<Work> work = work_;
  work->ended = false;
  const Time begun = executor_.now();
  std::function<void(const std::function<bool()>&)> job = [work](const std::function<bool()>&) {
    if (!work->group.lines.empty()) work->written = work->file->append(work->group);
    work->room = work->file->room();
    work->ended = true;
    work->ended.notify_all();
  };
  co_await executor_.offload(std::move(job), Duration::zero());
  const Duration took = executor_.now() - begun;
  if (work->group.durable) disk_takes_ = std::min((3 * disk_takes_ + took) / 4, longest_disk);
  finish();
}

void JournalWriter::finish() {
  const std::shared_ptr<Work> work = work_;
  const bool failed_before = failure_.has_value();
  room_ = work->room;
  failure_ = lack_of_room();
  stuck_ = !work->written;
  if (work->written) {
    kept_ = work->last;
    bytes_until_compaction_ -= std::min(bytes_until_compaction_, work->group.lines.size());
    work_ = nullptr;
  } else {
    failure_ = work->written.error();
  }
  if (on_progress) on_progress();
  if (failed_before != failure_.has_value() && on_failure) on_failure(failure_);
}

Task<void> JournalWriter::compact() {
  if (bytes_until_compaction_ > 0 || failure_) co_return;
  bytes_until_compaction_ = compaction_bytes;
  const std::shared_ptr<JournalFile> file = file_;
  const Time now = executor_.now();
  std::function<void(const std::function<bool()>&)> job = [file, now](const std::function<bool()>&) {
    // What could not be done now is tried again with the next.
    [[maybe_unused]] const Result<bool> more = file->compact(now);
  };
  co_await executor_.offload(std::move(job), Duration::zero());
}

}  // namespace pizarra
