#include "blackboard/recorded_board.hpp"

#include <coroutine>

#include "blackboard/journal.hpp"
#include "blackboard/store.hpp"

namespace pizarra {

namespace {

std::unexpected<Failure> read_only() { return fail("read-only", "a recorded board cannot be changed"); }

class RecordedWatch : public Watch {
 public:
  explicit RecordedWatch(Change first) : first_(std::move(first)) {}

  Task<Result<Change>> next() override {
    if (!first_) co_await std::suspend_always();
    Change first = std::move(*first_);
    first_.reset();
    co_return first;
  }

 private:
  std::optional<Change> first_;
};

}  // namespace

RecordedBoard::RecordedBoard(std::unique_ptr<Store> store) : store_(std::move(store)) {}
RecordedBoard::~RecordedBoard() = default;

Result<std::unique_ptr<RecordedBoard>> RecordedBoard::open(std::string_view journal, Revision last) {
  auto store = std::make_unique<Store>();
  const Result<void> replayed = replay(journal, *store, last);
  if (!replayed) return fail(replayed);
  return std::unique_ptr<RecordedBoard>(new RecordedBoard(std::move(store)));
}

Task<Result<void>> RecordedBoard::declare(std::vector<Relation> relations) {
  for (const Relation& relation : relations) {
    const auto standing = store_->tables().find(relation.name);
    if (standing == store_->tables().end() || standing->second.relation() != relation) co_return read_only();
  }
  co_return Result<void>();
}

Task<Result<Answers>> RecordedBoard::ask(Query query) { co_return store_->ask(query); }

Task<Result<std::unique_ptr<Watch>>> RecordedBoard::watch(Query query) {
  Result<Answers> answers = store_->ask(query);
  if (!answers) co_return fail(answers);
  co_return std::make_unique<RecordedWatch>(Change{answers->revision, true, std::move(answers->answers), {}});
}

Task<Result<Revision>> RecordedBoard::transact(Transaction) { co_return read_only(); }
Task<Result<std::optional<Fact>>> RecordedBoard::take(Datum, LeaseId) { co_return read_only(); }
Task<Result<LeaseId>> RecordedBoard::lease(Duration) { co_return read_only(); }
Task<Result<void>> RecordedBoard::renew(LeaseId) { co_return read_only(); }
Task<Result<void>> RecordedBoard::release(LeaseId) { co_return read_only(); }

}  // namespace pizarra
