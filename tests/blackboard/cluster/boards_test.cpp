// Two boards and an etcd, as programs: whoever leads is killed, stopped or ended, and the other one goes on with what
// was acknowledged.

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/log_keys.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/free_port.hpp"
#include "tests/run_task.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::cluster {
namespace {

class Boards : public testing::Test {
 protected:
  void SetUp() override {
    if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    etcd_ = std::make_unique<RealEtcd>();
    for (const int port : {free_port(), free_port()}) {
      addresses_.push_back("tcp://127.0.0.1:" + std::to_string(port));
    }
    for (const std::size_t number : {0, 1}) {
      // The files of an earlier test are the past of another log.
      std::filesystem::remove_all(past_of(number));
      start(number);
    }
    client_ = client::RemoteBoard::connect(executor_, addresses_[0] + "," + addresses_[1], "tester").value();
    const Relation note =
        relation_from_datum(read_one("(relation note ((n integer)) (key n) (durable))").value()).value();
    // The first board may take a while to find its etcd.
    for (int tries = 0; tries < 10 && !run(client_->declare({note})); ++tries) continue;
  }
  static std::string past_of(std::size_t number) { return scratch_folder() + "past-" + std::to_string(number); }
  void start(std::size_t number) {
    boards_[number] = std::make_unique<ChildProgram>(
        std::vector<std::string>{PIZARRA_BOARD, "--listen", addresses_[number], "--log", etcd_->address("boards"),
                                 "--name", "board-" + std::to_string(number), "--past", past_of(number)});
  }
  template <class T>
  T run(Task<T> task) {
    return pizarra::run(executor_, std::move(task));
  }
  // Told again where nobody can say whether it happened: the same note is the same fact.
  void tell(std::int64_t n) {
    for (int tries = 0; tries < 20; ++tries) {
      const Result<Revision> told = run(client_->tell(list("note"_sym, n)));
      if (told) return revisions_.push_back(*told);
    }
    FAIL() << "note " << n << " is not taken";
  }
  std::size_t notes() {
    const Result<std::vector<Fact>> facts = run(client_->facts(list("note"_sym, "?n"_sym)));
    return facts ? facts->size() : 0;
  }
  // Which board leads, by whose address is bound.
  std::size_t leader() const {
    for (const auto& [number, board] : boards_) {
      if (board != nullptr && listens(addresses_[number])) return number;
    }
    return boards_.size();
  }
  static bool listens(const std::string& address);

  std::unique_ptr<RealEtcd> etcd_;
  std::vector<std::string> addresses_;
  std::map<std::size_t, std::unique_ptr<ChildProgram>> boards_;
  RealExecutor executor_;
  std::unique_ptr<client::RemoteBoard> client_;
  std::vector<Revision> revisions_;
};

bool Boards::listens(const std::string& address) {
  return can_connect(std::stoi(address.substr(address.rfind(':') + 1)));
}

TEST_F(Boards, GoOnWithWhatWasAcknowledgedWhenTheLeaderIsKilled) {
  std::int64_t told = 0;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 20; ++i) tell(++told);
    const std::size_t leads = leader();
    ASSERT_LT(leads, boards_.size());
    boards_[leads]->stop(SIGKILL);
    tell(++told);
    EXPECT_EQ(notes(), static_cast<std::size_t>(told));
    EXPECT_NE(leader(), leads);
    start(leads);
  }
  EXPECT_TRUE(std::ranges::is_sorted(revisions_));
}

TEST_F(Boards, RefuseTheLogOfAnotherCell) {
  const auto board_of = [&](const std::string& cell) {
    const std::vector<std::string> words = {
        PIZARRA_BOARD, "--listen", "tcp://127.0.0.1:*", "--log", etcd_->address("shared"), "--cell", cell};
    return std::make_unique<ChildProgram>(words);
  };
  const auto blocks = board_of("blocks");
  for (std::string line = blocks->line(); !line.contains("ready on"); line = blocks->line()) ASSERT_NE(line, "");
  const auto kits = board_of("kits");
  EXPECT_EQ(kits->wait(), 4);
  const std::string said = kits->rest();
  EXPECT_TRUE(said.contains("this log has the facts of the cell blocks, and this is a board of the cell kits")) << said;
  EXPECT_EQ(blocks->stop(SIGTERM), 0);
  const auto again = board_of("blocks");
  std::string line = again->line();
  while (!line.empty() && !line.contains("ready on")) line = again->line();
  EXPECT_TRUE(line.contains("ready on")) << "it is its own";
}

TEST_F(Boards, EndWithASentenceWhereTheLogIsOfANewerFormat) {
  const auto etcd = EtcdClient::open(LogAddress::from(etcd_->address("newer"), "", false).value()).value();
  const KeyValue newer{LogKeys("newer").format(), "3"};
  ASSERT_TRUE(etcd->transact({.compares = {}, .puts = {newer}}, 5s).has_value());
  ChildProgram board({PIZARRA_BOARD, "--listen", "tcp://127.0.0.1:*", "--log", etcd_->address("newer")});
  EXPECT_EQ(board.wait(), 4);
  const std::string said = board.rest();
  EXPECT_TRUE(said.contains("the log in the cluster is of format 3, and this build reads formats 1 and 2")) << said;
}

TEST_F(Boards, HearNothingMoreOfALeaderThatWasStoppedAndComesBack) {
  tell(1);
  const std::size_t leads = leader();
  boards_[leads]->send(SIGSTOP);
  tell(2);
  const std::size_t now = leader();
  boards_[leads]->send(SIGCONT);
  tell(3);
  EXPECT_EQ(notes(), 3u);
  EXPECT_TRUE(std::ranges::is_sorted(revisions_));
  (void)now;
}

TEST_F(Boards, TellAWatcherThatItMayHaveMissedSomethingAndGoOnBehindWhatItKnew) {
  tell(1);
  const std::unique_ptr<Watch> watch = run(client_->watch(query_for(list("note"_sym, "?n"_sym)))).value();
  const Change first = run(watch->next()).value();
  EXPECT_TRUE(first.resynchronised);
  EXPECT_EQ(first.added.size(), 1u);
  boards_[leader()]->stop(SIGKILL);
  tell(2);
  std::set<std::int64_t> known = {1};
  Revision revision = first.revision;
  bool told_of_a_gap = false;
  while (!known.contains(2)) {
    const Change change = run(watch->next()).value();
    EXPECT_GE(change.revision, revision);
    revision = change.revision;
    if (change.resynchronised) known.clear();
    told_of_a_gap = told_of_a_gap || change.resynchronised;
    for (const Answer& answer : change.removed) known.erase(answer.facts.front().datum[1].integer());
    for (const Answer& answer : change.added) known.insert(answer.facts.front().datum[1].integer());
  }
  EXPECT_TRUE(told_of_a_gap);
  EXPECT_EQ(known, (std::set<std::int64_t>{1, 2}));
}

// A note a line that it says, as they are acknowledged.
TEST_F(Boards, AreOneBoardForAClientInPythonToo) {
  const std::string script =
      "import pizarra\n"
      "board = pizarra.Board('" +
      addresses_[0] + "," + addresses_[1] +
      "', 'script')\n"
      "n = 100\n"
      "while True:\n"
      "    n += 1\n"
      "    try:\n"
      "        board.tell('(note %d)' % n)\n"
      "        print(n, flush=True)\n"
      "    except pizarra.Failure:\n"
      "        pass\n";
  setenv("PYTHONPATH", (source_dir() + "/blackboard/python").c_str(), 1);
  tell(1);
  ChildProgram client({"/usr/bin/python3", "-c", script});
  std::vector<std::string> acknowledged;
  while (acknowledged.size() < 20) acknowledged.push_back(client.line());
  boards_[leader()]->stop(SIGKILL);
  while (acknowledged.size() < 60) acknowledged.push_back(client.line());
  client.stop(SIGKILL);
  for (const std::string& n : acknowledged) {
    const Result<std::vector<Fact>> facts = run(client_->facts(list("note"_sym, std::stoll(n))));
    EXPECT_TRUE(facts && facts->size() == 1) << n;
  }
}

TEST_F(Boards, AreRecalledInPythonWhereNobodyLeads) {
  const std::string script =
      "import pizarra\n"
      "board = pizarra.Board('" +
      addresses_[0] + "," + addresses_[1] +
      "', 'script', waits=False)\n"
      "while True:\n"
      "    try:\n"
      "        board.tell('(note 7)')\n"
      "        print('told', flush=True)\n"
      "    except pizarra.Failure as failure:\n"
      "        if failure.symbol != 'unavailable': raise\n"
      "        recalled = board.recall('(note ?n)')\n"
      "        print(recalled.age > 0.25, len(recalled), flush=True)\n";
  setenv("PYTHONPATH", (source_dir() + "/blackboard/python").c_str(), 1);
  tell(1);
  ChildProgram client({"/usr/bin/python3", "-c", script});
  EXPECT_EQ(client.line(), "told");
  etcd_->signal(SIGSTOP);
  std::string said = "told";
  while (said == "told") said = client.line();
  EXPECT_EQ(said, "True 2");
  etcd_->signal(SIGCONT);
  for (int tries = 0; tries < 100 && said != "told"; ++tries) said = client.line();
  EXPECT_EQ(said, "told");
  client.stop(SIGKILL);
}

TEST_F(Boards, SayWhatWasNotDurableWhileTheyLedAndOtherwiseThatTheyDoNotKnow) {
  const Relation seen = relation_from_datum(read_one("(relation seen ((n integer)) (key n))").value()).value();
  ASSERT_TRUE(run(client_->declare({seen})).has_value());
  const Result<Revision> told = run(client_->tell(list("seen"_sym, 1)));
  ASSERT_TRUE(told.has_value()) << describe(told.error());
  tell(1);
  Query then = query_for(list("seen"_sym, "?n"_sym));
  then.at = Moment{.revision = *told};
  const Result<Answers> known = run(client_->ask(then));
  ASSERT_TRUE(known.has_value()) << describe(known.error());
  EXPECT_EQ(known->answers.size(), 1u);
  boards_[leader()]->stop(SIGKILL);
  tell(2);
  const Result<Answers> unknown = run(client_->ask(then));
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().symbol, "gap") << describe(unknown.error());
}

TEST_F(Boards, HandOverAtOnceWhenTheLeaderIsEndedInOrder) {
  tell(1);
  const std::size_t leads = leader();
  EXPECT_EQ(boards_[leads]->stop(SIGTERM), 0);
  tell(2);
  EXPECT_EQ(notes(), 2u);
}

TEST_F(Boards, ChangeNothingWithoutALogSayHowItWasAndGoOnWhenItIsBack) {
  tell(1);
  const Query all = query_for(list("note"_sym, "?n"_sym));
  etcd_->signal(SIGSTOP);
  const Time begun = executor_.now();
  const Result<Revision> told = run(client_->tell(list("note"_sym, std::int64_t{2})));
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "unavailable");
  EXPECT_FALSE(run(client_->ask(all)).has_value()) << "nor what may be old by now";
  const auto recalled = run(client_->recall(all));
  ASSERT_TRUE(recalled.has_value()) << describe(recalled.error());
  EXPECT_GT(recalled->age, 250ms);
  EXPECT_FALSE(recalled->answers.answers.empty());
  EXPECT_GT(run(client_->recall(all))->age, recalled->age);
  const auto impatient = client::RemoteBoard::connect(executor_, addresses_[0] + "," + addresses_[1], "hasty").value();
  impatient->refuse_without_quorum();
  EXPECT_EQ(run(impatient->tell(list("note"_sym, std::int64_t{9}))).error().sentence,
            "the board has no quorum of its log: this was not done");
  EXPECT_LT(executor_.now() - begun, 60s);
  etcd_->signal(SIGCONT);
  tell(3);
  const std::size_t standing = notes();
  EXPECT_TRUE(standing == 2 || standing == 3) << standing;
}

}  // namespace
}  // namespace pizarra::cluster
