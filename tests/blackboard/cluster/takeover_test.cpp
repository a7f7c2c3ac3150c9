// Boards that take over from each other, in virtual time, on an etcd that has bad days: whatever is acknowledged is
// in the log once, answers are never older than what was acknowledged, and revisions only grow. The boards stand by and
// lead as in their program (lead.hpp). PIZARRA_SEEDS says how many days.

#include <cstdlib>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <memory>
#include <set>

#include "blackboard/cluster/log_leader.hpp"
#include "blackboard/cluster/take_snapshot.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys cell_keys("cell");

// What clients asked for: request N tells (mark N DOING); one that is not answered is asked for again, by the same
// number. DOING is another one whenever a board does it, so that one that was done twice has two facts.
struct Clients {
  std::uint64_t next = 1;
  std::int64_t next_doing = 1;
  bool boards_forget_replies = false;  // a fault that is planted: what was answered before is done again
  std::set<std::uint64_t> open;
  std::set<std::uint64_t> acknowledged;
  Revision seen = 0;  // the highest revision of any answer
  std::vector<std::string> faults;
};

// Work away from the boards' threads takes as long as the model says. Now and then a thread is kept from running.
class ModelExecutor : public VirtualExecutor {
 public:
  explicit ModelExecutor(EtcdModel& etcd) : etcd_(etcd) {}
  Time now() const override { return works_ ? etcd_.now : VirtualExecutor::now(); }
  Task<void> offload(std::function<void(const std::function<bool()>&)> work, Duration) override {
    const Duration late = stall();
    co_await sleep(*this, late);
    etcd_.now = VirtualExecutor::now();
    works_ = true;
    work([] { return false; });
    works_ = false;
    const Duration took = etcd_.now - VirtualExecutor::now() + stall();
    co_await sleep(*this, took);
  }

 private:
  Duration stall() { return etcd_.happens(0.02) ? Duration(etcd_.below(400'000)) : Duration::zero(); }

  EtcdModel& etcd_;
  bool works_ = false;
};

class ModelBoard {
 public:
  ModelBoard(ModelExecutor& executor, EtcdModel& etcd, Clients& clients, std::string name)
      : executor_(executor),
        etcd_(etcd),
        clients_(clients),
        name_(std::move(name)),
        client_(std::make_shared<ModelClient>(etcd)) {
    begin();
  }
  // Power off and on.
  void begin() {
    life_ = Job();
    end_lead();
    life_ = executor_.spawn(live());
  }
  ModelClient& client() { return *client_; }
  // One who lives.
  void suspect() { standby_->suspect(); }
  void take_a_snapshot() { (void)take_snapshot(*client_, cell_keys, etcd_.random()); }

 private:
  Task<void> live() {
    while (true) {
      standby_ = std::make_shared<Standby>(*client_, cell_keys, name_, etcd_.random() >> 2, executor_.now());
      const Result<void> leads = co_await stand_by(executor_, standby_, on_attempt_);
      if (!leads) co_return;
      leader_ =
          std::make_unique<LogLeader>(executor_, needs(), cell_keys, standby_, standby_->must_wait(executor_.now()));
      confirming_ = executor_.spawn(leader_->confirm());
      co_await leader_->catch_up();
      if (!leader_->ended()) co_await serve();
      note(*leader_->ended());
      end_lead();
    }
  }
  LogLeader::Needs needs() {
    return {.connect = [this] { return std::shared_ptr<KeyValues>(client_); },
            .nonce = [this] { return etcd_.random(); },
            .uptime = [this] { return executor_.now().time_since_epoch(); },
            .on_log = on_attempt_,
            .on_upkeep = on_attempt_,
            .on_end = [] {}};
  }
  void end_lead() {
    confirming_ = Job();
    upkeep_ = Job();
    leader_.reset();
    log_.reset();
    pending_.reset();
    store_.reset();
    requests_.clear();
    replies_.clear();
  }
  Task<void> serve() {
    begin_board();
    upkeep_ = executor_.spawn(leader_->keep_in_space());
    co_await leader_->until_it_serves();
    while (!leader_->ended()) {
      const Duration pause(etcd_.below(5'000));
      co_await sleep(executor_, pause);
      const bool writes = etcd_.happens(0.5);
      if (writes) co_await write();
      if (!writes) answer();
    }
  }
  void begin_board() {
    LogLeader::Begun begun = leader_->begin("etcd://model").value();
    log_ = std::move(begun.log);
    store_ = std::move(begun.store);
    if (!clients_.boards_forget_replies) {
      for (const journal::RememberedReply& reply : begun.replies) replies_.insert(reply.request);
    }
    leader_->counters = [this] { return LogLeader::Counters{store_->revision(), store_->next_fact()}; };
    (void)store_->declare(
        {relation_from_datum(read_one("(relation mark ((n integer) (doing integer)) (durable))").value()).value()});
    pending_.emplace();
    pending_->lines =
        journal::journal_line(0, executor_.now(), "board", {store_->tables().at("mark").relation()}) + '\n';
    store_->on_commit([this](const store::Commit& commit) { pending_->lines += journal::journal_line(commit) + '\n'; });
  }
  // One request in a group, or what was in doubt once more.
  Task<void> write() {
    const bool answered = !pending_ && !take_request();
    if (answered) co_return;
    Result<void> written;
    std::function<void(const std::function<bool()>&)> append = [&](auto&&) { written = log_->append(*pending_, true); };
    co_await executor_.offload(std::move(append), Duration::zero());
    if (!written && written.error().symbol == "deposed") co_return leader_->end(written.error());
    on_attempt_(written);
    if (written) are_written();
  }
  // Whether there is something to write of it: it may have been answered before.
  bool take_request() {
    const std::uint64_t request = choose();
    if (replies_.contains(request)) {
      acknowledge(request);
      return false;
    }
    pending_.emplace();
    requests_ = {request};
    Transaction telling;
    telling.tell(list("mark"_sym, static_cast<std::int64_t>(request), clients_.next_doing++));
    (void)store_->transact("client", telling, executor_.now());
    journal::ReplyLines().add(pending_->replies, {7, "client", request, "ok"_sym, ""});
    return true;
  }
  void are_written() {
    pending_.reset();
    for (const std::uint64_t request : std::exchange(requests_, {})) {
      replies_.insert(request);
      acknowledge(request);
    }
  }
  void acknowledge(std::uint64_t request) {
    if (!leader_->may_answer()) return;
    clients_.acknowledged.insert(request);
    clients_.open.erase(request);
    heard(store_->revision());
  }
  std::uint64_t choose() {
    if (!clients_.open.empty() && etcd_.happens(0.7)) return *clients_.open.begin();
    clients_.open.insert(clients_.next);
    return clients_.next++;
  }
  // An ask: as the server, nothing while it holds what is not in the log.
  void answer() {
    if (pending_ || !leader_->may_answer()) return;
    for (const std::uint64_t request : clients_.acknowledged) {
      const Query query = query_for(list("mark"_sym, static_cast<std::int64_t>(request), "?"_sym));
      const std::size_t known = store_->ask(query)->answers.size();
      if (known == 1) continue;
      clients_.faults.push_back(fmt::format("{} knows {} {} times", name_, request, known));
    }
    heard(store_->revision());
  }
  void heard(Revision revision) {
    if (revision < clients_.seen) clients_.faults.push_back(name_ + " answers with a former revision");
    clients_.seen = std::max(clients_.seen, revision);
  }
  void note(const Failure& failure) {
    const bool expected = failure.symbol == "unavailable" || failure.symbol == "deposed";
    if (!expected) clients_.faults.push_back(name_ + ": " + describe(failure));
  }

  ModelExecutor& executor_;
  EtcdModel& etcd_;
  Clients& clients_;
  const std::string name_;
  const std::shared_ptr<ModelClient> client_;
  const OnAttempt on_attempt_ = [this](const Result<void>& attempt) {
    if (!attempt) note(attempt.error());
  };
  std::shared_ptr<Standby> standby_;
  std::unique_ptr<LogLeader> leader_;
  std::shared_ptr<ClusterLog> log_;
  std::unique_ptr<store::Store> store_;
  std::set<std::uint64_t> replies_;
  std::optional<journal::JournalGroup> pending_;
  std::vector<std::uint64_t> requests_;
  Job confirming_;
  Job upkeep_;
  Job life_;
};

// The marks in the log at the end, each as often as it was told.
std::multiset<std::int64_t> marks_of(EtcdModel& etcd) {
  ModelClient reader(etcd);
  FollowedLog followed(reader, cell_keys);
  while (true) {
    const Result<std::size_t> came = followed.follow();
    if (came && *came == 0) break;
    // A snapshot may come late.
    EXPECT_TRUE(came || came.error().symbol == "unavailable");
  }
  std::multiset<std::int64_t> marks;
  const auto table = followed.store().tables().find("mark");
  if (table == followed.store().tables().end()) return marks;
  for (const store::StandingFact& standing : table->second.facts()) marks.insert(standing.fact.datum[1].integer());
  return marks;
}

using Boards = std::vector<std::unique_ptr<ModelBoard>>;

void have_a_bad_moment(EtcdModel& etcd, const Boards& boards) {
  ModelBoard& board = *boards[etcd.below(boards.size())];
  if (etcd.happens(0.01)) board.begin();
  if (etcd.happens(0.02)) board.client().cut = !board.client().cut;
  if (etcd.happens(0.01)) board.suspect();
  if (etcd.happens(0.02)) board.take_a_snapshot();
}

// Compares what clients were acknowledged with the log at the end.
std::vector<std::string> faults_in(const std::multiset<std::int64_t>& marks,
                                   const std::set<std::uint64_t>& acknowledged) {
  std::vector<std::string> faults;
  for (const std::uint64_t request : acknowledged) {
    if (marks.contains(static_cast<std::int64_t>(request))) continue;
    faults.push_back(fmt::format("{} was acknowledged and is not there", request));
  }
  for (auto mark = marks.begin(); mark != marks.end(); mark = marks.upper_bound(*mark)) {
    const std::size_t times = marks.count(*mark);
    if (times > 1) faults.push_back(fmt::format("{} was done {} times", *mark, times));
  }
  return faults;
}

struct BadDay {
  std::size_t acknowledged = 0;
  std::vector<std::string> faults;
};

BadDay live_through(std::uint64_t seed, bool boards_forget_replies = false) {
  EtcdModel etcd(seed);
  // So little on some days that snapshots are taken all the time, and it is full now and then.
  if (etcd.happens(0.3)) etcd.space.most = 400'000;
  ModelExecutor executor(etcd);
  executor.run_for(1s);
  Clients clients;
  clients.boards_forget_replies = boards_forget_replies;
  Boards boards;
  for (const char* name : {"a", "b", "c"}) {
    boards.push_back(std::make_unique<ModelBoard>(executor, etcd, clients, name));
  }
  for (int moment = 0; moment < 400; ++moment) {
    executor.run_for(Duration(etcd.below(50'000)));
    have_a_bad_moment(etcd, boards);
  }
  boards.clear();
  etcd.trouble = 0;
  BadDay day{clients.acknowledged.size(), std::move(clients.faults)};
  for (std::string& fault : faults_in(marks_of(etcd), clients.acknowledged)) day.faults.push_back(std::move(fault));
  return day;
}

TEST(Takeover, LosesNothingAcknowledgedAndAnswersNothingOldOnBadDaysOfEtcd) {
  const char* asked = std::getenv("PIZARRA_SEEDS");
  const std::uint64_t seeds = asked == nullptr ? 3000 : std::stoull(asked);
  std::size_t acknowledged = 0;
  for (std::uint64_t seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed) {
    const BadDay day = live_through(seed);
    acknowledged += day.acknowledged;
    for (const std::string& fault : day.faults) ADD_FAILURE() << "seed " << seed << ": " << fault;
  }
  EXPECT_GT(acknowledged, 5 * seeds);
  RecordProperty("acknowledged", static_cast<int>(acknowledged));
}

TEST(TakeoverJudge, FindsWhatWasDoneTwiceAndWhatIsMissing) {
  EXPECT_EQ(
      faults_in({1, 2, 2, 4, 4, 4}, {1, 2, 3}),
      (std::vector<std::string>{"3 was acknowledged and is not there", "2 was done 2 times", "4 was done 3 times"}));
  EXPECT_TRUE(faults_in({1, 2, 4}, {1, 2}).empty()) << "4 was not answered and may be there";
}

TEST(TakeoverJudge, FindsThatBoardsDoAgainWhatTheLogRemembersToBeAnswered) {
  bool found = false;
  for (std::uint64_t seed = 1; seed <= 200 && !found; ++seed) {
    for (const std::string& fault : live_through(seed, true).faults) found |= fault.contains(" was done 2 times");
  }
  EXPECT_TRUE(found);
}

// The time at which a board's time begins that takes the lead from one whose clock is an hour ahead.
Time earliest_time_after(const std::function<void(WonEpoch&, KeyValues&, Time)>& leads) {
  EtcdModel etcd(1);
  etcd.trouble = 0;
  ModelClient client(etcd);
  const auto now = [&etcd] { return etcd.now; };
  Standby former(client, cell_keys, "ahead", 1, etcd.now);
  EXPECT_EQ(former.step(now), true);
  WonEpoch epoch = former.take_epoch();
  leads(epoch, client, etcd.now + 3600s);
  Standby next(client, cell_keys, "behind", 2, etcd.now);
  next.suspect();
  for (int looks = 0; looks < 3; ++looks) {
    const Result<bool> won = next.step(now);
    if (won && *won) return next.earliest_time();
    etcd.now += suspects_after;
  }
  ADD_FAILURE() << "it does not take the lead";
  return {};
}

TEST(Takeover, BeginsBehindEveryTimeAtWhichALeaderWithAnotherClockMayHaveAnswered) {
  Time said{};
  const Time after_power_off = earliest_time_after([&](WonEpoch& epoch, KeyValues& etcd, Time ahead) {
    said = ahead;
    ASSERT_TRUE(epoch.confirm(etcd, ahead, 1, 1).has_value());
  });
  EXPECT_EQ(after_power_off, said + answers_for);
  const Time after_goodbye = earliest_time_after([&](WonEpoch& epoch, KeyValues& etcd, Time ahead) {
    said = ahead;
    ASSERT_TRUE(epoch.confirm(etcd, ahead - 50ms, 1, 1).has_value());
    ASSERT_TRUE(epoch.resign(etcd, ahead).has_value());
  });
  EXPECT_EQ(after_goodbye, said);
}

}  // namespace
}  // namespace pizarra::cluster
