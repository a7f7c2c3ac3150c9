#include "programs/board/cluster_board.hpp"

#include <fmt/format.h>
#include <memory>

#include "blackboard/boards_own.hpp"
#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/etcd_client.hpp"
#include "blackboard/cluster/log_owner.hpp"
#include "blackboard/cluster/log_upkeep.hpp"
#include "blackboard/cluster/standby.hpp"
#include "blackboard/server/kept_board.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "blackboard/wire/gated_transport.hpp"
#include "programs/board/exits.hpp"

namespace pizarra::programs {

namespace {

using cluster::EtcdClient;
using cluster::Leadership;
using cluster::Standby;

// Each epoch gives out leases of its own.
constexpr int bits_of_leases = 40;

void say(const std::string& news) {
  fmt::print("pizarra-board: {}\n", news);
  std::fflush(stdout);
}

// A trouble with etcd is reported once, until it becomes another one.
class Troubles {
 public:
  void note(const Result<void>& result) {
    const std::string now = result ? "" : describe(result.error());
    if (now == said_) return;
    said_ = now;
    fmt::print(stderr, "pizarra-board: {}\n", now.empty() ? "the log answers again" : now);
  }

 private:
  std::string said_;
};

// (board-leads NAME), told by the board; gone with its lead.
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

using Work = std::function<void(const std::function<bool()>& cancelled)>;

class StandingBy {
 public:
  StandingBy(const ClusterChoices& choices, std::shared_ptr<EtcdClient> client)
      : cell_(choices.cell),
        keys_(choices.log.cell),
        client_(std::move(client)),
        standby_(std::make_shared<Standby>(*client_, keys_, choices.name, server::Sessions::random_number(),
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
    const auto claimed = std::make_shared<bool>(cell_.empty());
    while (!leads_ && !failure_) {
      const auto step = std::make_shared<Result<bool>>(false);
      const auto now = [this] { return executor_.now(); };
      Work work = [=, client = client_, standby = standby_, keys = keys_, cell = cell_](const std::function<bool()>&) {
        const Result<void> mine = *claimed ? Result<void>() : cluster::claim_log(*client, keys, cell);
        *claimed = mine.has_value();
        *step = mine ? standby->step(now) : fail(mine);
      };
      co_await executor_.offload(std::move(work), Duration::zero());
      note(*step);
      if (leads_) co_return;
      co_await sleep(executor_, cluster::looks_every);
    }
  }
  void note(const Result<bool>& step) {
    leads_ = step.value_or(false);
    if (!step && step.error().symbol != "unavailable") {
      failure_ = step.error();
    } else {
      troubles_.note(step ? Result<void>() : fail(step));
    }
  }

  RealExecutor executor_;
  const std::string cell_;
  const cluster::LogKeys keys_;
  const std::shared_ptr<EtcdClient> client_;
  const std::shared_ptr<Standby> standby_;
  Troubles troubles_;
  bool leads_ = false;
  std::optional<Failure> failure_;
};

// While this board leads.
class Leading {
 public:
  Leading(const ClusterChoices& choices, std::shared_ptr<EtcdClient> client, std::shared_ptr<Standby> standby,
          Duration waits)
      : choices_(choices),
        keys_(choices.log.cell),
        client_(std::move(client)),
        standby_(std::move(standby)),
        leadership_(std::make_shared<Leadership>(standby_->take_leadership())),
        executor_(std::max(RealExecutor::wall_clock(), standby_->copy().end().when)),
        serves_at_(executor_.now() + waits),
        gated_(
            wire::zeromq(), [this] { return may_answer(); },
            [this](const std::string& sender_key, std::string_view frame) { return in_doubt(sender_key, frame); }) {}

  // The exit status, or nothing where another board leads now.
  std::optional<int> run();

 private:
  bool may_answer() const {
    return !deposed_ && !leaves_ &&
           term_.may_answer(executor_.now(), kept_ == nullptr ? 0 : kept_->board().store().revision());
  }
  // The answer to a frame while it is not known whether this board leads.
  std::string in_doubt(const std::string& sender_key, std::string_view frame) const {
    if (deposed_ || leaves_ || server_ == nullptr || !term_.sent()) return "";
    return server_->answer_in_doubt(sender_key, frame, executor_.now() - *term_.sent());
  }
  Task<void> confirm();
  Task<void> catch_up();
  Task<void> keep_in_space(std::shared_ptr<cluster::LogSpace> space);
  void heard(const Result<Revision>& up_to, Time sent);
  void end(const Failure& failure);
  void keep_past(const store::Store& store, const std::shared_ptr<const journal::Log>& log);
  std::optional<int> serve();

  const ClusterChoices& choices_;
  const cluster::LogKeys keys_;
  const std::shared_ptr<EtcdClient> client_;  // of the log
  const std::shared_ptr<Standby> standby_;
  const std::shared_ptr<Leadership> leadership_;
  RealExecutor executor_;
  const Time serves_at_;
  wire::GatedTransport gated_;
  cluster::Term term_;
  Troubles troubles_;
  Troubles upkeep_troubles_;
  bool leaves_ = false;
  std::optional<Failure> deposed_;
  std::optional<Failure> broken_;
  std::unique_ptr<cluster::OwnPast> past_;
  std::unique_ptr<server::KeptBoard> kept_;
  std::unique_ptr<server::BoardServer> server_;
};

void Leading::end(const Failure& failure) {
  (failure.symbol == "deposed" ? deposed_ : broken_) = failure;
  executor_.stop();
}

Task<void> Leading::confirm() {
  Result<std::unique_ptr<EtcdClient>> opened = EtcdClient::open(choices_.log);
  if (!opened) co_return end(opened.error());
  const std::shared_ptr<EtcdClient> client = std::move(*opened);
  while (!leaves_) {
    const Time sent = executor_.now();
    const Revision revision = kept_ == nullptr ? 0 : kept_->board().store().revision();
    const FactId fact = kept_ == nullptr ? 0 : kept_->board().store().next_fact();
    const auto up_to = std::make_shared<Result<Revision>>(Revision{0});
    Work work = [=, leadership = leadership_](const std::function<bool()>&) {
      *up_to = leadership->confirm(*client, sent, revision, fact);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    heard(*up_to, sent);
    if (deposed_) co_return;
    co_await sleep(executor_, std::max(sent + cluster::confirms_every - executor_.now(), Duration(1000)));
  }
  // Whoever stands by need not wait.
  Work leave = [=, this, leadership = leadership_](const std::function<bool()>&) {
    (void)leadership->resign(*client, executor_.now());
  };
  co_await executor_.offload(std::move(leave), Duration::zero());
}

void Leading::heard(const Result<Revision>& up_to, Time sent) {
  if (up_to) {
    term_.confirmed(sent, *up_to);
    return troubles_.note({});
  }
  if (up_to.error().symbol == "deposed") return end(up_to.error());
  troubles_.note(fail(up_to));
}

// What came to the log before this board led.
Task<void> Leading::catch_up() {
  bool whole = false;
  while (!whole) {
    const auto done = std::make_shared<Result<void>>();
    Work work = [=, this, client = client_, standby = standby_](const std::function<bool()>&) {
      const Result<std::optional<std::uint64_t>> head = cluster::head_of(*client, keys_);
      *done = head ? standby->copy().follow_to(head->value_or(0)) : fail(head);
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    whole = done->has_value();
    if (whole) co_return;
    troubles_.note(*done);
    if (done->error().symbol != "unavailable") co_return end(done->error());
    co_await sleep(executor_, cluster::looks_every);
  }
}

Task<void> Leading::keep_in_space(std::shared_ptr<cluster::LogSpace> space) {
  Result<std::unique_ptr<EtcdClient>> opened = EtcdClient::open(choices_.log);
  if (!opened) co_return;
  const auto upkeep =
      std::make_shared<cluster::LogUpkeep>(std::shared_ptr<EtcdClient>(std::move(*opened)), keys_, std::move(space));
  while (true) {
    co_await sleep(executor_, cluster::upkeep_every);
    const auto kept = std::make_shared<Result<void>>();
    // What could not be done now is tried again.
    Work work = [upkeep, kept, now = executor_.now()](const std::function<bool()>&) {
      *kept = upkeep->step(now, server::Sessions::random_number());
    };
    co_await executor_.offload(std::move(work), Duration::zero());
    upkeep_troubles_.note(*kept);
  }
}

std::optional<int> Leading::run() {
  const StopSignals signals(executor_);
  const Job confirming = executor_.spawn(confirm());
  {
    const Job catching_up = executor_.spawn(catch_up());
    executor_.run_until([&] { return catching_up.done(); });
    if (!catching_up.done()) return stopped;
  }
  if (broken_) return complain(*broken_, bad_journal);
  if (deposed_) return std::nullopt;
  const std::optional<int> status = serve();
  server_.reset();
  kept_.reset();
  past_.reset();
  leaves_ = true;
  if (status && !deposed_) executor_.run_until([&] { return confirming.done(); });
  return status;
}

// A board leads without one rather than not at all.
void Leading::keep_past(const store::Store& store, const std::shared_ptr<const journal::Log>& log) {
  if (choices_.past.folder.empty()) return;
  const auto complain_of = [](const Failure& failure) {
    fmt::print(stderr, "pizarra-board: {}; what is not durable is not kept while it leads\n", describe(failure));
  };
  Result<std::unique_ptr<cluster::OwnPast>> past =
      cluster::OwnPast::begin(executor_, choices_.past, choices_.log.cell, leadership_->epoch().number, store,
                              {leadership_->first_revision(), executor_.now()}, log);
  if (!past) return complain_of(past.error());
  past_ = std::move(*past);
  past_->on_end = complain_of;
}

std::optional<int> Leading::serve() {
  Result<std::unique_ptr<EtcdClient>> reading = EtcdClient::open(choices_.log);
  if (!reading) return complain(reading.error(), bad_address);
  const auto log = std::make_shared<cluster::ClusterLog>(client_, std::shared_ptr<EtcdClient>(std::move(*reading)),
                                                         keys_, leadership_->epoch(), standby_->copy().number(),
                                                         choices_.log.text, standby_->copy().weight());
  std::vector<journal::RememberedReply> replies = standby_->copy().replies();
  std::unique_ptr<store::Store> store = standby_->copy().take_store();
  store->restore_counters(leadership_->first_revision(), leadership_->first_fact());
  kept_ = std::make_unique<server::KeptBoard>(executor_, [this](const std::optional<Failure>& failure) {
    if (failure && failure->symbol == "deposed") return end(*failure);
    troubles_.note(failure ? fail(*failure) : Result<void>());
  });
  keep_past(*store, log);
  store::JournalSink all;
  if (past_ != nullptr) all = [this](std::string_view line) { past_->add(line); };
  kept_->lead(std::move(store), leadership_->epoch().number << bits_of_leases, std::move(replies), log, std::move(all));
  const Result<void> told = say_who_leads(kept_->board(), choices_.name);
  if (!told) return complain(told.error(), bad_journal);
  const Job upkeep = executor_.spawn(keep_in_space(log->space()));
  bool may_serve = false;
  executor_.call_at(serves_at_, [&] { may_serve = true; });
  executor_.run_until([&] { return may_serve; });
  if (deposed_) return std::nullopt;
  if (!may_serve) return stopped;
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
  if (deposed_) return std::nullopt;
  server_->say_goodbye();
  executor_.call_at(executor_.now() + server::BoardServer::goodbye_length, [this] { executor_.stop(); });
  executor_.run_until([] { return false; });
  return stopped;
}

}  // namespace

int serve_in_cluster(const ClusterChoices& choices) {
  while (true) {
    Result<std::unique_ptr<EtcdClient>> opened = EtcdClient::open(choices.log);
    if (!opened) return complain(opened.error(), bad_address);
    const std::shared_ptr<EtcdClient> client = std::move(*opened);
    say("stands by at " + choices.log.text);
    StandingBy standing(choices, client);
    const std::shared_ptr<Standby> standby = standing.run();
    if (standing.failure()) return complain(*standing.failure(), bad_journal);
    if (standby == nullptr) return stopped;
    say("leads");
    Leading leading(choices, client, standby, standing.must_wait());
    const std::optional<int> status = leading.run();
    if (status) return *status;
    say("another board leads");
  }
}

}  // namespace pizarra::programs
