#include "blackboard/journal/journal_writer.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pizarra::journal {

namespace {

constexpr Duration not_waited_for = 100ms;
constexpr Duration try_again_after = 250ms;
constexpr Duration let_go_again_after = 1s;
constexpr Duration longest_disk = 20ms;  // that company is waited for in proportion to
constexpr std::size_t compacted_after_bytes = 256 << 10;

}  // namespace

JournalWriter::JournalWriter(Executor& executor, std::shared_ptr<Log> log)
    : executor_(executor),
      log_(std::move(log)),
      room_(log_->room()),
      failure_(lack_of_room()),
      due_(executor),
      job_(executor.spawn(write_groups())) {}

JournalWriter::~JournalWriter() {
  if (timer_ != 0) executor_.cancel(timer_);
  job_ = Job();
  if (work_ != nullptr) {
    work_->ended.wait(false);
    // Nobody waits any more for what cannot be written now.
    work_->may_spend = true;
    if (!work_->written) work_->write();
    if (!work_->written) return;
  }
  while (!pending_.empty()) {
    take_pending();
    work_->write();
    if (!work_->written) return;
  }
}

void JournalWriter::Work::write() {
  if (!what.group.lines.empty()) written = log->append(what.group, may_spend);
}

void JournalWriter::append(std::string_view line) {
  if (pending_.empty() || pending_.back().group.bytes() >= log_->group_bytes()) pending_.emplace_back();
  Pending& last = pending_.back();
  last.group.lines += line;
  last.group.lines += '\n';
  last.last = ++position_;
  if (!failure_ && last.group.bytes() >= log_->group_bytes()) due_.set();
  if (timer_ != 0) return;
  timer_ = executor_.call_at(executor_.now() + not_waited_for, [this] {
    timer_ = 0;
    due_.set();
  });
}

void JournalWriter::remember(const RememberedReply& reply) {
  if (!pending_.empty()) pending_.back().replies.add(pending_.back().group.replies, reply);
}

void JournalWriter::keep() {
  if (pending_.empty()) pending_.push_back({.group = {}, .last = position_});
  pending_.back().group.durable = true;
  ++pending_.back().waiting;
  if (is_writing_) return;
  const std::size_t here = waiting();
  const bool first_or_last = here == 1 || here == company_;
  if (first_or_last) wait_for_company();
}

void JournalWriter::wait_for_company() {
  const bool all_are_here = waiting() >= company_;
  write_at(executor_.now() + (all_are_here ? Duration::zero() : disk_takes_ / 8));
}

void JournalWriter::write_at(Time when) {
  if (timer_ != 0) executor_.cancel(timer_);
  timer_ = executor_.call_at(when, [this] {
    timer_ = 0;
    due_.set();
  });
}

std::size_t JournalWriter::waiting() const {
  std::size_t all = 0;
  for (const Pending& pending : pending_) all += pending.waiting;
  return all;
}

std::optional<Failure> JournalWriter::lack_of_room() const {
  if (room_.for_all > 0) return std::nullopt;
  return Failure{"journal-full", room_.lacking.empty() ? log_->path() + ": the disk is full" : room_.lacking, {}, {}};
}

Result<void> JournalWriter::check_room(Change change, std::size_t bytes) const {
  const bool refused = change == Change::lasting ? failure_.has_value() : change == Change::removing && stuck_;
  if (refused) return fail(*failure_);
  const std::array most = {most_passing(), room_.for_all, room_.for_removals};
  if (waiting_bytes() + bytes <= most[static_cast<std::size_t>(change)]) return {};
  if (failure_) return fail(*failure_);
  if (room_.is_scarce) return fail("journal-full", log_->path() + ": the disk has too little space left for this");
  return fail("journal-full", "too much waits to be written to " + log_->path());
}

// On a full disk it must leave room for the removals that come after it.
std::size_t JournalWriter::most_passing() const {
  const bool in_the_way = failure_ && !stuck_ && room_.for_removals > 0;
  return in_the_way ? room_.for_removals / 2 : max_waiting_bytes;
}

std::size_t JournalWriter::waiting_bytes() const {
  std::size_t bytes = work_ == nullptr ? 0 : work_->what.group.bytes();
  for (const Pending& pending : pending_) bytes += pending.group.bytes();
  return bytes;
}

bool JournalWriter::durable_waits() const {
  return std::ranges::any_of(pending_, [](const Pending& pending) { return pending.group.durable; });
}

Task<void> JournalWriter::write_groups() {
  while (true) {
    const std::optional<Time> again = look_again();
    co_await due_.wait(again);
    due_.reset();
    if (work_ == nullptr) take_pending();
    co_await write_group();
    co_await compact();
  }
}

// The past that could not be let go yet can be later.
std::optional<Time> JournalWriter::look_again() const {
  if (failure_) return executor_.now() + try_again_after;
  if (room_.past_goes) return executor_.now() + let_go_again_after;
  return std::nullopt;
}

void JournalWriter::take_pending() {
  work_ = std::make_shared<Work>();
  work_->log = log_;
  work_->what.last = kept_;
  if (pending_.empty()) return;
  work_->what = std::move(pending_.front());
  pending_.pop_front();
  // All of it was due.
  if (!pending_.empty()) due_.set();
}

Task<void> JournalWriter::write_group() {
  const std::shared_ptr<Work> work = work_;
  work->ended = false;
  // On a full disk, what need not last leaves what is set aside alone, unless what must last comes after it.
  work->may_spend = room_.for_all > 0 || work->what.group.durable || durable_waits();
  const Time begun = executor_.now();
  is_writing_ = true;
  std::function<void(const std::function<bool()>&)> job = [work](const std::function<bool()>&) {
    work->write();
    work->room = work->log->room();
    work->ended = true;
    work->ended.notify_all();
  };
  co_await executor_.offload(std::move(job), Duration::zero());
  is_writing_ = false;
  const Duration took = executor_.now() - begun;
  if (work->what.group.durable) disk_takes_ = std::min((3 * disk_takes_ + took) / 4, longest_disk);
  finish();
}

void JournalWriter::finish() {
  const std::shared_ptr<Work> work = work_;
  const bool failed_before = failure_.has_value();
  room_ = work->room;
  failure_ = lack_of_room();
  stuck_ = !work->written && work->may_spend && !leaves_in_doubt(work->written.error());
  if (work->written) {
    kept_ = work->what.last;
    written_bytes_ += work->what.group.bytes();
    work_ = nullptr;
    company_ = work->what.waiting + waiting();
    if (waiting() > 0) wait_for_company();
  } else {
    failure_ = work->written.error();
    // Something that must last has come meanwhile.
    if (!work->may_spend && durable_waits()) due_.set();
  }
  if (on_progress) on_progress();
  if (failed_before != failure_.has_value() && on_failure) on_failure(failure_);
}

// A slice at a time, so that what is to be written need not wait long.
Task<void> JournalWriter::compact() {
  if (!room_.past_goes && (failure_ || written_bytes_ < compacted_after_bytes)) co_return;
  const std::shared_ptr<Log> log = log_;
  const Time now = executor_.now();
  const auto gone = std::make_shared<std::size_t>(0);
  std::function<void(const std::function<bool()>&)> job = [log, now, gone](const std::function<bool()>&) {
    // Failed work is tried again with the next group.
    *gone = log->compact(now).value_or(0);
  };
  co_await executor_.offload(std::move(job), Duration::zero());
  written_bytes_ -= std::min(*gone == 0 ? written_bytes_ : *gone, written_bytes_);
  const bool more = *gone > 0 && (room_.past_goes || written_bytes_ >= compacted_after_bytes);
  if (more) due_.set();
}

}  // namespace pizarra::journal
