#include "blackboard/memory/recorded_board.hpp"

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/journal/past.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::memory {

namespace {

std::unexpected<Failure> read_only() { return fail("read-only", "a recorded board cannot be changed"); }

}  // namespace

RecordedBoard::RecordedBoard(Executor& executor, std::unique_ptr<store::Store> store, journal::PlayedBack played)
    : store_(*store),
      lacks_(std::move(played.lacks)),
      board_(executor, std::move(store)),
      view_(board_.view("recorded")),
      lines_(std::move(played.later)),
      when_(played.to.when) {}

RecordedBoard::~RecordedBoard() = default;

Result<std::unique_ptr<RecordedBoard>> RecordedBoard::open(Executor& executor, const std::string& path,
                                                           const Moment& until) {
  auto store = std::make_unique<store::Store>();
  Result<journal::PlayedBack> played = journal::read_journal(path, *store, until);
  if (!played) return fail(played);
  return of(executor, std::move(store), std::move(*played));
}

std::unique_ptr<RecordedBoard> RecordedBoard::of(Executor& executor, std::unique_ptr<store::Store> store,
                                                 journal::PlayedBack played) {
  return std::unique_ptr<RecordedBoard>(new RecordedBoard(executor, std::move(store), std::move(played)));
}

Revision RecordedBoard::revision() const { return store_.revision(); }

std::optional<std::string_view> RecordedBoard::next_line() const {
  const std::string_view rest = std::string_view(lines_).substr(at_);
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  return rest.substr(0, end);
}

std::optional<Time> RecordedBoard::next() const {
  const std::optional<std::string_view> line = next_line();
  if (!line) return std::nullopt;
  return journal::start_of_line(*line).when;
}

Result<bool> RecordedBoard::step() {
  const Revision before = revision();
  while (revision() == before) {
    const std::optional<std::string_view> line = next_line();
    if (!line) return false;
    at_ += line->size() + 1;
    when_ = journal::start_of_line(*line).when;
    const Result<void> replayed = journal::replay_line(*line, store_);
    if (!replayed) return fail(replayed);
  }
  return true;
}

Task<Result<void>> RecordedBoard::declare(std::vector<Relation> relations) {
  for (const Relation& relation : relations) {
    const auto standing = store_.tables().find(relation.name);
    if (standing == store_.tables().end() || standing->second.relation() != relation) co_return read_only();
  }
  co_return Result<void>();
}

Task<Result<Answers>> RecordedBoard::ask(Query query) {
  const Result<void> has = journal::check_has(lacks_, store_, query);
  if (!has) co_return fail(has);
  Result<Answers> answers = co_await view_->ask(std::move(query));
  if (!answers) co_return fail(journal::failure_at(revision(), std::move(answers.error())));
  co_return answers;
}

Task<Result<std::unique_ptr<Watch>>> RecordedBoard::watch(Query query) {
  const Result<void> has = journal::check_has(lacks_, store_, query);
  if (!has) co_return fail(has);
  Result<std::unique_ptr<Watch>> watch = co_await view_->watch(std::move(query));
  if (!watch) co_return fail(journal::failure_at(revision(), std::move(watch.error())));
  co_return watch;
}

Task<Result<Revision>> RecordedBoard::transact(Transaction) { co_return read_only(); }
Task<Result<std::optional<Fact>>> RecordedBoard::take(Datum, LeaseId) { co_return read_only(); }
Task<Result<LeaseId>> RecordedBoard::lease(Duration) { co_return read_only(); }
Task<Result<void>> RecordedBoard::renew(LeaseId) { co_return read_only(); }
Task<Result<void>> RecordedBoard::release(LeaseId) { co_return read_only(); }

}  // namespace pizarra::memory
