#include "programs/board/cluster_board.hpp"

#include <fmt/format.h>
#include <memory>

#include "blackboard/boards_own.hpp"
#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/log_leader.hpp"
#include "blackboard/cluster/log_owner.hpp"
#include "blackboard/cluster/troubles.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/server/key_folder.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "blackboard/time/uptime.hpp"
#include "blackboard/wire/gated_transport.hpp"
#include "programs/board/exits.hpp"

namespace pizarra::programs {

namespace {

using cluster::EtcdClient;
using cluster::Standby;

// Each epoch gives out leases of its own.
constexpr int bits_of_leases = 40;

void say(const std::string& news) {
  fmt::print("pizarra-board: {}\n", news);
  std::fflush(stdout);
}

void report(cluster::Troubles& troubles, const Result<void>& result, Time now) {
  const std::optional<std::string> news = troubles.news(result, now);
  if (news) fmt::print(stderr, "pizarra-board: {}\n", *news);
}

// (board-leads NAME), told by the board; it goes when another leads.
Result<void> say_who_leads(memory::MemoryBoard& board, const std::string& name) {
  const Relation relation{.name = "board-leads",
                          .arguments = {{"name", ArgumentType::string}},
                          .key = std::vector<std::size_t>(),
                          .durable = false,
                          .lease = {}};
  const Result<void> declared = board.declare(std::string(board_teller), {relation});
  if (!declared) return declared;
  const auto told = board.transact(std::string(board_teller), Transaction().tell(list("board-leads"_sym, name)));
  return told ? Result<void>() : fail(told);
}

Result<std::shared_ptr<cluster::KeyValues>> connect(const cluster::LogAddress& log) {
  Result<std::unique_ptr<EtcdClient>> opened = EtcdClient::open(log);
  if (!opened) return fail(opened);
  return std::shared_ptr<EtcdClient>(std::move(*opened));
}

// Its folder of keys was checked before.
cluster::LogOwner owner_of(const ClusterChoices& choices) {
  cluster::LogOwner owner{choices.cell};
  if (choices.server.keys.empty()) return owner;
  const Result<server::KeyFolder> keys = server::KeyFolder::open(choices.server.keys);
  if (keys) owner.key = keys->own().public_key;
  return owner;
}

class StandingBy {
 public:
  StandingBy(const ClusterChoices& choices, std::shared_ptr<cluster::KeyValues> etcd)
      : owner_(owner_of(choices)),
        keys_(choices.log.cell),
        etcd_(std::move(etcd)),
        standby_(std::make_shared<Standby>(*etcd_, keys_, choices.name, server::Sessions::random_number(),
                                           executor_.now())) {}

  // Null when the program is to stop.
  std::shared_ptr<Standby> run() {
    const StopSignals signals(executor_);
    const Job job = executor_.spawn(stand_by());
    executor_.run_until([&] { return job.done(); });
    return leads_ ? standby_ : nullptr;
  }
  const std::optional<Failure>& failure() const { return failure_; }
  // How long the former leader may still answer.
  Duration must_wait() const { return standby_->must_wait(executor_.now()); }

 private:
  Task<void> stand_by() {
    const cluster::OnAttempt on_log = [this](const Result<void>& attempt) {
      report(troubles_, attempt, executor_.now());
    };
    co_await claim(on_log);
    if (failure_) co_return;
    const Result<void> leads = co_await cluster::stand_by(executor_, standby_, on_log);
    leads_ = leads.has_value();
    if (!leads) failure_ = leads.error();
  }

  // The log for this cell alone.
  Task<void> claim(cluster::OnAttempt on_log) {
    bool claimed = owner_.cell.empty();
    while (!claimed && !failure_) {
      const auto mine = std::make_shared<Result<void>>();
      std::function<void(const std::function<bool()>&)> work = [mine, etcd = etcd_, keys = keys_,
                                                                owner = owner_](auto&&) {
        *mine = cluster::claim_log(*etcd, keys, owner);
      };
      co_await executor_.offload(std::move(work), Duration::zero());
      claimed = mine->has_value();
      if (!claimed && mine->error().symbol != "unavailable") failure_ = mine->error();
      if (failure_) co_return;
      on_log(*mine);
      if (!claimed) co_await sleep(executor_, cluster::looks_every);
    }
  }

  RealExecutor executor_;
  const cluster::LogOwner owner_;
  const cluster::LogKeys keys_;
  const std::shared_ptr<cluster::KeyValues> etcd_;
  const std::shared_ptr<Standby> standby_;
  cluster::Troubles troubles_;
  bool leads_ = false;
  std::optional<Failure> failure_;
};

// Serves clients while this board leads.
class ServingLeader {
 public:
  ServingLeader(const ClusterChoices& choices, const std::shared_ptr<Standby>& standby, Duration waits)
      : choices_(choices),
        executor_(std::max(RealExecutor::wall_clock(), standby->earliest_time())),
        leader_(executor_, needs(), cluster::LogKeys(choices.log.cell), standby, waits),
        gated_(
            wire::zeromq(), [this] { return leader_.may_answer(); },
            [this](const std::string& sender_key, std::string_view frame) { return in_doubt(sender_key, frame); }) {}

  // The exit status, or nothing where another board leads now.
  std::optional<int> run();

 private:
  // The answer to a frame while it is not known whether this board leads.
  std::string in_doubt(const std::string& sender_key, std::string_view frame) const {
    const std::optional<Duration> age = leader_.age();
    return server_ == nullptr || !age ? "" : server_->answer_in_doubt(sender_key, frame, *age);
  }
  cluster::LogLeader::Needs needs();
  bool runs_until_done(Task<void> task);
  // Where it does not lead any more, or stops.
  std::optional<int> end() const;
  void keep_past(const store::Store& store, const std::shared_ptr<const journal::Log>& log);
  void keep_board(cluster::LogLeader::Begun begun);
  std::optional<int> serve();

  const ClusterChoices& choices_;
  RealExecutor executor_;
  cluster::Troubles troubles_;
  cluster::Troubles upkeep_troubles_;
  cluster::LogLeader leader_;
  wire::GatedTransport gated_;
  std::unique_ptr<cluster::OwnPast> past_;
  std::unique_ptr<server::KeptBoard> kept_;
  std::unique_ptr<server::BoardServer> server_;
};

cluster::LogLeader::Needs ServingLeader::needs() {
  return {.connect = [this] { return connect(choices_.log); },
          .nonce = server::Sessions::random_number,
          .uptime = uptime,
          .on_log = [this](const Result<void>& attempt) { report(troubles_, attempt, executor_.now()); },
          .on_upkeep = [this](const Result<void>& attempt) { report(upkeep_troubles_, attempt, executor_.now()); },
          .on_end = [this] { executor_.stop(); }};
}

bool ServingLeader::runs_until_done(Task<void> task) {
  const Job job = executor_.spawn(std::move(task));
  executor_.run_until([&] { return job.done(); });
  return job.done() && !leader_.ended();
}

std::optional<int> ServingLeader::end() const {
  if (!leader_.ended()) return stopped;
  if (leader_.ended()->symbol == "deposed") return std::nullopt;
  return complain(*leader_.ended(), leader_.ended()->symbol == "bad-address" ? bad_address : bad_journal);
}

std::optional<int> ServingLeader::run() {
  const StopSignals signals(executor_);
  const Job confirming = executor_.spawn(leader_.confirm());
  if (!runs_until_done(leader_.catch_up())) return end();
  const std::optional<int> status = serve();
  server_.reset();
  kept_.reset();
  past_.reset();
  leader_.leave();
  if (status && !leader_.ended()) executor_.run_until([&] { return confirming.done(); });
  return status;
}

// A board leads without one rather than not at all.
void ServingLeader::keep_past(const store::Store& store, const std::shared_ptr<const journal::Log>& log) {
  if (choices_.past.folder.empty()) return;
  const auto complain_of = [](const Failure& failure) {
    fmt::print(stderr, "pizarra-board: {}; what is not durable is not kept while it leads\n", describe(failure));
  };
  Result<std::unique_ptr<cluster::OwnPast>> past =
      cluster::OwnPast::begin(executor_, choices_.past, choices_.log.cell, leader_.epoch().value().number, store,
                              {leader_.epoch().first_revision(), executor_.now()}, log);
  if (!past) return complain_of(past.error());
  past_ = std::move(*past);
  past_->on_end = complain_of;
}

void ServingLeader::keep_board(cluster::LogLeader::Begun begun) {
  kept_ = std::make_unique<server::KeptBoard>(executor_, [this](const std::optional<Failure>& failure) {
    if (failure && failure->symbol == "deposed") return leader_.end(*failure);
    report(troubles_, failure ? fail(*failure) : Result<void>(), executor_.now());
  });
  keep_past(*begun.store, begun.log);
  store::JournalSink all;
  if (past_ != nullptr) all = [this](std::string_view line) { past_->add(line); };
  kept_->lead(std::move(begun.store), leader_.epoch().value().number << bits_of_leases, std::move(begun.replies),
              begun.log, std::move(all));
  leader_.counters = [this] {
    if (kept_ == nullptr) return cluster::LogLeader::Counters();
    const store::Store& store = kept_->board().store();
    return cluster::LogLeader::Counters{store.revision(), store.next_fact()};
  };
}

std::optional<int> ServingLeader::serve() {
  Result<cluster::LogLeader::Begun> begun = leader_.begin(choices_.log.text);
  if (!begun) return end();
  keep_board(std::move(*begun));
  const Result<void> told = say_who_leads(kept_->board(), choices_.name);
  if (!told) return complain(told.error(), bad_journal);
  const Job upkeep = executor_.spawn(leader_.keep_in_space());
  if (!runs_until_done(leader_.until_it_serves())) return end();
  server::BoardServerOptions options = choices_.server;
  options.journal = kept_->journal();
  options.past = past_ == nullptr ? nullptr : &past_->writer();
  options.remembered = kept_->take_remembered();
  options.answers_from_journal = true;
  options.transport = &gated_;
  Result<std::unique_ptr<server::BoardServer>> server = server::BoardServer::open(executor_, kept_->board(), options);
  if (!server) return complain(server.error(), bad_address);
  server_ = std::move(*server);
  say(fmt::format("ready on {}", fmt::join(server_->addresses(), " ")));
  executor_.run_until([] { return false; });
  if (leader_.ended()) return end();
  server_->say_goodbye();
  executor_.call_at(executor_.now() + server::BoardServer::goodbye_length, [this] { executor_.stop(); });
  executor_.run_until([] { return false; });
  return stopped;
}

}  // namespace

int serve_in_cluster(const ClusterChoices& choices) {
  while (true) {
    const Result<std::shared_ptr<cluster::KeyValues>> etcd = connect(choices.log);
    if (!etcd) return complain(etcd.error(), bad_address);
    say("stands by at " + choices.log.text);
    StandingBy standing(choices, *etcd);
    const std::shared_ptr<Standby> standby = standing.run();
    if (standing.failure()) return complain(*standing.failure(), bad_journal);
    if (standby == nullptr) return stopped;
    say("leads");
    ServingLeader leader(choices, standby, standing.must_wait());
    const std::optional<int> status = leader.run();
    if (status) return *status;
    say("another board leads");
  }
}

}  // namespace pizarra::programs
