// Boards that take over from each other, in virtual time, on an etcd that has bad days: whatever is acknowledged is
// in the log once, answers are never older than what was acknowledged, and revisions only grow. PIZARRA_SEEDS says how
// many days.

#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <set>

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/standby.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/cluster/etcd_model.hpp"

namespace pizarra::cluster {
namespace {

const LogKeys cell_keys("cell");

// What clients asked for: request N tells (mark N); one that is not answered is asked for again, by the same number.
struct Clients {
  std::uint64_t next = 1;
  std::set<std::uint64_t> open;
  std::set<std::uint64_t> acknowledged;
  Revision seen = 0;  // the highest revision of any answer
  std::vector<std::string> faults;
};

class ModelBoard {
 public:
  ModelBoard(EtcdModel& etcd, Clients& clients, std::string name)
      : etcd_(etcd), clients_(clients), name_(std::move(name)), client_(std::make_shared<ModelClient>(etcd)) {
    begin();
  }
  void step() {
    if (!leads_) return stand_by();
    if (!term_.sent() || etcd_.now >= *term_.sent() + confirms_every) confirm();
    if (!leads_ || etcd_.now < serves_at_) return;
    if (etcd_.happens(0.5)) {
      write();
    } else {
      answer();
    }
    if (leads_ && etcd_.happens(0.02)) (void)take_snapshot(*client_, cell_keys, etcd_.random());
  }
  // Power off and on.
  void begin() {
    leads_.reset();
    log_.reset();
    pending_.reset();
    store_.reset();
    requests_.clear();
    replies_.clear();
    term_ = {};
    standby_ = std::make_unique<Standby>(*client_, cell_keys, name_, etcd_.random() >> 2, etcd_.now);
  }
  ModelClient& client() { return *client_; }

 private:
  void stand_by() {
    // Now and then it suspects one who lives.
    if (etcd_.happens(0.01)) standby_->suspect();
    const Result<bool> leads = standby_->step([this] { return etcd_.now; });
    if (!leads) return note(leads.error());
    if (*leads) lead(standby_->take_leadership());
  }
  void lead(Leadership won) {
    serves_at_ = etcd_.now + standby_->must_wait(etcd_.now);
    const Result<std::optional<std::uint64_t>> head = head_of(*client_, cell_keys);
    const Result<void> whole = head ? standby_->copy().follow_to(**head) : fail(head);
    // It campaigns again, and finds that it leads.
    if (!whole) return note(whole.error());
    log_ = std::make_unique<ClusterLog>(client_, client_, cell_keys, won.epoch(), standby_->copy().number(),
                                        "etcd://model");
    for (const journal::RememberedReply& reply : standby_->copy().replies()) replies_.insert(reply.request);
    store_ = standby_->copy().take_store();
    store_->restore_counters(won.first_revision(), won.first_fact());
    (void)store_->declare(
        {relation_from_datum(read_one("(relation mark ((n integer)) (key n) (durable))").value()).value()});
    pending_.emplace();
    pending_->lines = journal::journal_line(0, etcd_.now, "board", {store_->tables().at("mark").relation()}) + '\n';
    store_->on_commit = [this](const store::Commit& commit) {
      pending_->lines += journal::journal_line(commit) + '\n';
    };
    leads_.emplace(std::move(won));
  }
  void confirm() {
    const Time sent = etcd_.now;
    const Result<Revision> up_to = leads_->confirm(*client_, sent, store_->revision(), store_->next_fact());
    if (up_to) return term_.confirmed(sent, *up_to);
    note(up_to.error());
    if (up_to.error().symbol == "deposed") begin();
  }
  // One request in a group, or what was in doubt once more.
  void write() {
    if (!pending_) {
      const std::uint64_t request = choose();
      if (replies_.contains(request)) return acknowledge(request);
      pending_.emplace();
      requests_ = {request};
      Transaction telling;
      telling.tell(list("mark"_sym, static_cast<std::int64_t>(request)));
      (void)store_->transact("client", telling, etcd_.now);
      journal::ReplyLines().add(pending_->replies, {7, "client", request, "ok"_sym, ""});
    }
    const Result<void> written = log_->append(*pending_, true);
    if (!written) {
      note(written.error());
      if (written.error().symbol == "deposed") begin();
      return;
    }
    pending_.reset();
    for (const std::uint64_t request : std::exchange(requests_, {})) {
      replies_.insert(request);
      acknowledge(request);
    }
  }
  void acknowledge(std::uint64_t request) {
    if (!term_.may_answer(etcd_.now, store_->revision())) return;
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
    if (pending_ || !term_.may_answer(etcd_.now, store_->revision())) return;
    for (const std::uint64_t request : clients_.acknowledged) {
      const Query query = query_for(list("mark"_sym, static_cast<std::int64_t>(request)));
      if (store_->ask(query)->answers.size() == 1) continue;
      clients_.faults.push_back(name_ + " does not know " + std::to_string(request));
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

  EtcdModel& etcd_;
  Clients& clients_;
  const std::string name_;
  const std::shared_ptr<ModelClient> client_;
  std::unique_ptr<Standby> standby_;
  std::optional<Leadership> leads_;
  Term term_;
  Time serves_at_{};
  std::unique_ptr<ClusterLog> log_;
  std::unique_ptr<store::Store> store_;
  std::set<std::uint64_t> replies_;
  std::optional<journal::JournalGroup> pending_;
  std::vector<std::uint64_t> requests_;
};

// The marks in the log at the end, each as often as it was told.
std::multiset<std::int64_t> marks_of(EtcdModel& etcd) {
  ModelClient reader(etcd);
  LogCopy copy(reader, cell_keys);
  while (true) {
    const Result<std::size_t> came = copy.follow();
    if (came && *came == 0) break;
    // A snapshot may come late.
    EXPECT_TRUE(came || came.error().symbol == "unavailable");
  }
  std::multiset<std::int64_t> marks;
  const auto table = copy.store().tables().find("mark");
  if (table == copy.store().tables().end()) return marks;
  for (const store::StandingFact& standing : table->second.facts()) marks.insert(standing.fact.datum[1].integer());
  return marks;
}

std::size_t live_through(std::uint64_t seed) {
  EtcdModel etcd(seed);
  etcd.now = Time(Duration(1'000'000));
  Clients clients;
  std::vector<std::unique_ptr<ModelBoard>> boards;
  for (const char* name : {"a", "b", "c"}) boards.push_back(std::make_unique<ModelBoard>(etcd, clients, name));
  for (int step = 0; step < 400; ++step) {
    ModelBoard& board = *boards[etcd.below(boards.size())];
    if (etcd.happens(0.01)) board.begin();
    if (etcd.happens(0.02)) board.client().cut = !board.client().cut;
    if (etcd.happens(0.05)) etcd.now += Duration(etcd.below(400'000));
    board.step();
    etcd.now += Duration(etcd.below(5000));
  }
  etcd.trouble = 0;
  const std::multiset<std::int64_t> marks = marks_of(etcd);
  for (const std::uint64_t request : clients.acknowledged) {
    if (marks.count(static_cast<std::int64_t>(request)) == 1) continue;
    clients.faults.push_back(std::to_string(request) + " was acknowledged and is not there");
  }
  for (const std::string& fault : clients.faults) ADD_FAILURE() << "seed " << seed << ": " << fault;
  return clients.acknowledged.size();
}

TEST(Takeover, LosesNothingAcknowledgedAndAnswersNothingOldOnBadDaysOfEtcd) {
  const char* asked = std::getenv("PIZARRA_SEEDS");
  const std::uint64_t seeds = asked == nullptr ? 300 : std::stoull(asked);
  std::size_t acknowledged = 0;
  for (std::uint64_t seed = 1; seed <= seeds && !testing::Test::HasFailure(); ++seed)
    acknowledged += live_through(seed);
  EXPECT_GT(acknowledged, 5 * seeds);
  RecordProperty("acknowledged", static_cast<int>(acknowledged));
}

}  // namespace
}  // namespace pizarra::cluster
