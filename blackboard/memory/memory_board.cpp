#include "blackboard/memory/memory_board.hpp"

#include <algorithm>
#include <cassert>

#include "blackboard/boards_own.hpp"
#include "blackboard/journal/journal.hpp"
#include "blackboard/memory/own_permissions.hpp"
#include "blackboard/store/provenance.hpp"
#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/teller.hpp"
#include "blackboard/time/latch.hpp"
#include "blackboard/watch/watch_table.hpp"

namespace pizarra::memory {

namespace {

constexpr Duration look_again_after = 5ms;
constexpr Duration between_parts = 1ms;

// As it is told in this process, where everything may be known.
template <class T>
Result<T> told(Result<T> result, const store::Store& store) {
  std::size_t examined = 0;
  const auto may_know = [](std::string_view) { return true; };
  if (!result) result.error() = store::with_nearest(std::move(result.error()), store.tables(), may_know, examined);
  return result;
}

store::Commit durable_part(const store::Commit& commit, const store::Store& store) {
  store::Commit part{.revision = commit.revision, .when = commit.when, .teller = commit.teller, .entries = {}};
  for (const store::Commit::Entry& entry : commit.entries) {
    const auto table = store.tables().find(entry.fact.datum.head());
    if (table != store.tables().end() && table->second.relation().durable) part.entries.push_back(entry);
  }
  return part;
}

class MemoryWatch : public Watch {
 public:
  explicit MemoryWatch(Executor& executor) : waiters_(executor) {}
  void attach(std::unique_ptr<watch::WatchQueue> queue) { queue_ = std::move(queue); }
  void wake() { waiters_.wake_all(); }

  Task<Result<Change>> next() override {
    while (!queue_->ready()) {
      co_await waiters_.wait();
    }
    co_return queue_->pop();
  }

 private:
  WaitList waiters_;
  std::unique_ptr<watch::WatchQueue> queue_;
};

class View : public Board {
 public:
  View(MemoryBoard& board, std::string teller) : board_(board), teller_(std::move(teller)) {
    assert(check_teller_name(teller_));
  }

  Task<Result<void>> declare(std::vector<Relation> relations) override { co_return board_.declare(teller_, relations); }
  Task<Result<Revision>> transact(Transaction transaction) override { co_return board_.transact(teller_, transaction); }
  Task<Result<Answers>> ask(Query query) override { co_return board_.ask(query, teller_); }
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override {
    co_return board_.take(teller_, pattern, holder);
  }
  Task<Result<LeaseId>> lease(Duration length) override { co_return board_.lease(length); }
  Task<Result<void>> renew(LeaseId lease) override { co_return board_.renew(lease); }
  Task<Result<void>> release(LeaseId lease) override { co_return board_.release(lease); }

  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override {
    auto watch = std::make_unique<MemoryWatch>(board_.executor());
    Result<std::unique_ptr<watch::WatchQueue>> queue =
        board_.watch(teller_, query, [watch = watch.get()] { watch->wake(); });
    if (!queue) co_return fail(queue);
    watch->attach(std::move(*queue));
    co_return watch;
  }

 private:
  MemoryBoard& board_;
  const std::string teller_;
};

}  // namespace

MemoryBoard::MemoryBoard(Executor& executor) : MemoryBoard(executor, std::make_unique<store::Store>()) {}

MemoryBoard::MemoryBoard(Executor& executor, std::unique_ptr<store::Store> store)
    : executor_(executor),
      store_(std::move(store)),
      watches_(std::make_unique<watch::WatchTable>(*store_)),
      may_lapse_(store::Lapsing::lapsing_at_once) {
  store_->on_commit([this](const store::Commit& commit) { committed(commit); });
  schedule();
}

MemoryBoard::~MemoryBoard() {
  if (timer_ != 0) executor_.cancel(timer_);
}

MemoryBoard::Hearing::Hearing(MemoryBoard& board, std::function<Time()> until)
    : board_(board), until_(std::move(until)) {
  board_.hearings_.push_back(this);
}

MemoryBoard::Hearing::~Hearing() { std::erase(board_.hearings_, this); }

std::unique_ptr<Board> MemoryBoard::view(std::string teller) {
  return std::make_unique<View>(*this, std::move(teller));
}

void MemoryBoard::set_journal(store::JournalSink sink) {
  journal_ = std::move(sink);
  journal_declared(journal_);
}

void MemoryBoard::set_journal_of_durable(store::JournalSink sink) {
  durable_journal_ = std::move(sink);
  journal_declared(durable_journal_);
}

// What was declared so far.
void MemoryBoard::journal_declared(const store::JournalSink& sink) const {
  std::vector<Relation> declared;
  for (const auto& [name, table] : store_->tables()) declared.push_back(table.relation());
  if (sink && !declared.empty()) sink(journal::journal_line(store_->revision(), executor_.now(), "board", declared));
}

void MemoryBoard::resume() {
  store_->resume(executor_.now());
  schedule();
}

Result<void> MemoryBoard::declare(const std::string& teller, const std::vector<Relation>& relations) {
  for (const Relation& relation : relations) {
    const bool own = is_told_by_the_board(relation.name) && teller != board_teller;
    if (own) return fail(left_to_the_board(relation.name));
  }
  const Result<std::vector<Relation>> fresh = store_->declare(relations);
  if (!fresh) return fail(fresh);
  for (const store::JournalSink* sink : {&journal_, &durable_journal_}) {
    if (*sink && !fresh->empty()) (*sink)(journal::journal_line(store_->revision(), executor_.now(), teller, *fresh));
  }
  return {};
}

Result<Revision> MemoryBoard::transact(const std::string& teller, const Transaction& transaction,
                                       std::size_t& examined) {
  const Time now = begin();
  const Result<Revision> revision = store_->transact(teller, transaction, now, examined);
  schedule();
  return revision;
}

Result<Answers> MemoryBoard::ask(const Query& query, std::size_t& examined, std::string_view asker) {
  const Time now = begin();
  const store::AskedAt asked{store_->revision(), now};
  // Whoever asks here, and not through a server's keys, may do everything.
  if (store::asks_for(query, own_permission)) return own_permissions(every_permission(), query, asked, examined);
  if (store::asks_for(query, provenance)) return store::provenance_of(query, *store_, asked, examined);
  const bool about_the_board = Statistics::is_about(query);
  Result<Answers> answers =
      about_the_board ? statistics_.ask(query, *store_, *watches_, now, examined) : store_->ask(query, examined);
  if (answers && !about_the_board) statistics_.asked(asker, query, store_->revision());
  schedule();
  return answers;
}

Result<std::optional<Fact>> MemoryBoard::take(const std::string& teller, const Datum& pattern, LeaseId holder,
                                              std::size_t& examined) {
  const Time now = begin();
  Result<std::optional<Fact>> taken = store_->take(teller, pattern, holder, now, examined);
  if (taken && *taken) statistics_.taken(teller, (*taken)->datum, store_->revision());
  schedule();
  return taken;
}

Result<LeaseId> MemoryBoard::lease(Duration length) {
  const Time now = begin();
  const Result<LeaseId> lease = store_->lease(length, now);
  schedule();
  return lease;
}

Result<void> MemoryBoard::renew(LeaseId lease) {
  const Time now = begin();
  const Result<void> renewed = store_->renew(lease, now);
  schedule();
  return renewed;
}

Result<void> MemoryBoard::release(LeaseId lease) {
  std::size_t examined = 0;
  return release(lease, examined);
}

Result<void> MemoryBoard::release(LeaseId lease, std::size_t& examined) {
  const Time now = begin();
  Result<void> released;
  lapse(now, [&](std::size_t& left) {
    std::size_t took = 0;
    released = store_->release(lease, now, took);
    examined += took;
    left -= std::min(left, took);
  });
  schedule();
  return released;
}

Result<std::unique_ptr<watch::WatchQueue>> MemoryBoard::watch(const std::string& watcher, const Query& query,
                                                              std::function<void()> ready,
                                                              std::shared_ptr<watch::Backlog> backlog,
                                                              std::size_t& examined) {
  begin();
  Result<std::unique_ptr<watch::WatchQueue>> queue =
      watches_->add(query, std::move(ready), watcher, std::move(backlog), examined);
  schedule();
  return queue;
}

Result<Revision> MemoryBoard::transact(const std::string& teller, const Transaction& transaction) {
  std::size_t examined = 0;
  return told(transact(teller, transaction, examined), *store_);
}

Result<Answers> MemoryBoard::ask(const Query& query, std::string_view asker) {
  std::size_t examined = 0;
  return told(ask(query, examined, asker), *store_);
}

Result<std::optional<Fact>> MemoryBoard::take(const std::string& teller, const Datum& pattern, LeaseId holder) {
  std::size_t examined = 0;
  return told(take(teller, pattern, holder, examined), *store_);
}

Result<std::unique_ptr<watch::WatchQueue>> MemoryBoard::watch(const std::string& watcher, const Query& query,
                                                              std::function<void()> ready) {
  std::size_t examined = 0;
  return told(watch(watcher, query, std::move(ready), std::make_shared<watch::Backlog>(), examined), *store_);
}

Time MemoryBoard::begin() {
  const Time now = executor_.now();
  const std::optional<Time> due = store_->next_expiry();
  if (due && *due <= now) lapse(now, [&](std::size_t& left) { store_->expire(heard_until(now), now, left); });
  return now;
}

// Others are served in the pause, and those whose requests come meanwhile have no part of it to wait for.
template <class Lapse>
void MemoryBoard::lapse(Time now, Lapse&& some) {
  if (now >= lapses_again_) may_lapse_ = store::Lapsing::lapsing_at_once;
  const std::size_t before = may_lapse_;
  some(may_lapse_);
  if (may_lapse_ < before) lapses_again_ = executor_.now() + between_parts;
}

Time MemoryBoard::heard_until(Time now) const {
  Time until = now;
  for (const Hearing* hearing : hearings_) until = std::min(until, hearing->until_());
  return until;
}

void MemoryBoard::schedule() {
  const std::optional<Time> due = store_->next_expiry();
  if (due == timer_due_) return;
  if (timer_ != 0) executor_.cancel(timer_);
  timer_ = 0;
  timer_due_ = due;
  if (!due) return;
  // A watch whose change is due already waits to be read, or for its part.
  const Time now = executor_.now();
  const Time again = may_lapse_ == 0 ? std::max(lapses_again_, now) : now + look_again_after;
  timer_ = executor_.call_at(*due > now ? *due : again, [this] {
    timer_ = 0;
    timer_due_.reset();
    begin();
    schedule();
  });
}

void MemoryBoard::committed(const store::Commit& commit) {
  if (journal_) journal_(journal::journal_line(commit));
  if (durable_journal_) {
    const store::Commit durable = durable_part(commit, *store_);
    if (!durable.entries.empty()) durable_journal_(journal::journal_line(durable));
  }
  statistics_.committed(commit);
  watches_->committed(commit);
}

}  // namespace pizarra::memory
