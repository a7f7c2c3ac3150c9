#include "blackboard/journal/past.hpp"

#include <algorithm>

#include "blackboard/boards_own.hpp"
#include "blackboard/store/provenance.hpp"

namespace pizarra::journal {

namespace {

constexpr Duration look_again_after = 5ms;
// A time that people say lasts to the end of its second.
constexpr Duration longest_second = 1s;

// Whether it asks about anything that a log of durable facts alone does not have.
bool asks_about_passing(const store::Store& store, const Query& query) {
  return std::ranges::any_of(query.clauses, [&](const Query::Clause& clause) {
    if (clause.kind == Query::Clause::Kind::compare) return false;
    const auto table = store.tables().find(clause.form.head());
    return table != store.tables().end() && !table->second.relation().durable;
  });
}

Result<Answers> answer_from(const Log& log, Query query) {
  store::Store store;
  const Result<PlayedBack> read = log.read(store, *query.at);
  if (!read) return fail(read);
  const Result<void> has = check_has(read->lacks, store, query);
  if (!has) return fail(has);
  query.at.reset();
  std::size_t examined = 0;
  if (store::asks_for(query, provenance)) {
    return store::provenance_of(query, store, {read->to.revision, read->to.when}, examined);
  }
  Result<Answers> answers = store.ask(query);
  if (!answers) return fail(failure_at(store.revision(), std::move(answers.error())));
  return answers;
}

}  // namespace

Result<void> check_has(const std::optional<Failure>& lacks, const store::Store& store, const Query& query) {
  return lacks && asks_about_passing(store, query) ? fail(*lacks) : Result<void>();
}

Past::Past(Executor& executor, JournalWriter& journal, std::function<Revision()> newest)
    : executor_(executor),
      journal_(journal),
      newest_(std::move(newest)),
      asked_(executor),
      job_(executor.spawn(answer_all())) {}

void Past::ask(const std::string& client, Query query, Done done) {
  auto asking = std::ranges::find(clients_, client, &Client::name);
  if (asking != clients_.end() && asking->waiting.size() >= max_waiting_of_a_client) {
    const std::string most = std::to_string(max_waiting_of_a_client);
    return done(fail("too-many", most + " questions about the past of " + client + " wait already", to_datum(client)));
  }
  if (waiting_ >= max_waiting) return done(fail("too-many", "too many questions about the past wait"));
  if (asking == clients_.end()) asking = clients_.insert(clients_.end(), Client{.name = client});
  asking->waiting.push_back({std::move(query), std::move(done)});
  ++waiting_;
  asked_.set();
}

void Past::end_turn() {
  Client client = std::move(clients_.front());
  clients_.pop_front();
  client.waiting.pop_front();
  --waiting_;
  if (!client.waiting.empty()) clients_.push_back(std::move(client));
}

Task<void> Past::answer_all() {
  while (true) {
    co_await asked_.wait();
    asked_.reset();
    while (!clients_.empty()) {
      const Result<Answers> answers = co_await answer(clients_.front().waiting.front().query);
      clients_.front().waiting.front().done(answers);
      end_turn();
    }
  }
}

Task<Result<Answers>> Past::answer(Query query) {
  const bool timed = query.at->revision == Moment().revision;
  if (timed && query.at->time > executor_.now() + longest_second) {
    co_return fail("not-yet", "this is later than the board's clock",
                   to_datum(query.at->time.time_since_epoch().count()));
  }
  // A log of durable facts alone may end before the board's newest revision.
  const Result<PlayedBack> reached = check_reached(PlayedBack{{newest_(), executor_.now()}, ""}, *query.at);
  if (!reached) co_return fail(reached);
  // Everything told before the question must be in the file.
  const JournalWriter::Position last = journal_.position();
  journal_.keep();
  while (journal_.kept() < last && !journal_.stuck()) {
    co_await sleep(executor_, look_again_after);
  }
  const auto answers = std::make_shared<Result<Answers>>(Answers());
  const std::shared_ptr<const Log> log = journal_.log();
  std::function<void(const std::function<bool()>&)> job = [=](const std::function<bool()>&) {
    *answers = answer_from(*log, query);
  };
  co_await executor_.offload(std::move(job), Duration::zero());
  co_return *answers;
}

}  // namespace pizarra::journal
