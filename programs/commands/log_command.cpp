// `log copy`: a cell's durable facts from the journal in a file to a log in an etcd cluster, or back. `log member`: a
// member of that cluster.

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <thread>
#include <unistd.h>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/cluster/log_transfer.hpp"
#include "blackboard/server/sessions.hpp"
#include "blackboard/time/real_executor.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/kept_journal.hpp"
#include "programs/host/log_member.hpp"

namespace pizarra::programs {

namespace {

struct CopyChoices {
  std::string from;
  std::string to;
  std::string certificates;
  bool insecure = false;
};

Result<cluster::Transferred> copy(const CopyChoices& choices) {
  const bool to_cluster = cluster::LogAddress::is_one(choices.to);
  if (to_cluster == cluster::LogAddress::is_one(choices.from)) {
    return fail("malformed", "one of both is a file, and the other a log: etcd://A,B,C/CELL");
  }
  const Result<OpenLog> log =
      open_log({to_cluster ? choices.to : choices.from, choices.certificates, choices.insecure});
  if (!log) return fail(log);
  if (!to_cluster) {
    const cluster::Pause pause = [](Duration length) { std::this_thread::sleep_for(length); };
    return cluster::cluster_to_file(*log->key_values, log->keys, choices.to, pause);
  }
  return cluster::file_to_cluster(choices.from, *log->key_values, log->keys, server::Sessions::random_number());
}

int run_copy(const CopyChoices& choices) {
  const Result<cluster::Transferred> copied = copy(choices);
  if (!copied) {
    const std::string& symbol = copied.error().symbol;
    const bool wrong = symbol == "malformed" || symbol == "bad-address" || symbol == "not-loopback";
    return complain(copied.error(), wrong ? exit_usage : exit_failed);
  }
  fmt::print("{}: {} durable facts, revision {}\n", choices.to, copied->facts, copied->revision);
  return exit_reached;
}

struct MemberChoices {
  std::string log;
  std::string here;
  std::string folder;
  std::string certificates;
  bool insecure = false;
};

// It ends then, and says why; `up` starts it again.
constexpr Duration waits_for_others = 25s;

Task<void> find_beginning(Executor& executor, host::MemberHere member, Result<cluster::Beginning>* begins) {
  host::SayWaiting say = [](const Failure& waits) { (void)complain(waits, exit_unavailable); };
  *begins = co_await host::beginning_of(executor, std::move(member), executor.now() + waits_for_others, std::move(say));
}

Result<cluster::Beginning> await_beginning(const host::MemberHere& member) {
  RealExecutor executor;
  Result<cluster::Beginning> begins = cluster::Beginning::anew;
  const Job job = executor.spawn(find_beginning(executor, member, &begins));
  executor.run_until([&] { return job.done(); });
  return begins;
}

Result<void> has_its_place(const host::MemberHere& member) {
  Result<void> sound = host::check_member(member);
  if (sound) sound = host::prepare_member(member);
  return sound ? host::check_ports(member) : sound;
}

// Becomes the member.
int run_member(const MemberChoices& choices) {
  const Result<cluster::LogAddress> log =
      cluster::LogAddress::from(choices.log, choices.certificates, choices.insecure);
  if (!log) return complain(log.error(), exit_usage);
  const host::MemberHere member{*log, choices.here, choices.folder};
  const Result<void> sound = has_its_place(member);
  if (!sound) return complain(sound.error(), sound.error().symbol == "bad-address" ? exit_usage : exit_unavailable);
  const Result<cluster::Beginning> begins = host::has_data(member) ? cluster::Beginning::anew : await_beginning(member);
  if (!begins) return complain(begins.error(), exit_unavailable);
  std::vector<std::string> command = host::etcd_command(member, *begins);
  std::vector<char*> words;
  for (std::string& word : command) words.push_back(word.data());
  words.push_back(nullptr);
  execv(words.front(), words.data());
  return complain(Failure{"no-program", fmt::format("{}: {}", command.front(), std::strerror(errno)), {}, {}},
                  exit_unavailable);
}

void add_member_command(CLI::App& log, int& status) {
  auto choices = std::make_shared<MemberChoices>();
  CLI::App* member = log.add_subcommand(
      "member", "Run an etcd member of a log on this host, as `up --log-here` does; one without data is brought back.");
  member->add_option("LOG", choices->log, "The log: etcd://A,B,C/CELL")->required();
  member->add_option("ADDRESS", choices->here, "Which of its members this host has")->required();
  member->add_option("DIR", choices->folder, "Where it keeps its data, on a disk that lasts")->required();
  add_log_options(*member, choices->certificates, choices->insecure);
  member->footer(help_footer("log member etcd://127.0.0.1/blocks 127.0.0.1 /var/lib/pizarra-etcd"));
  member->callback([choices, &status] { status = run_member(*choices); });
}

}  // namespace

void add_log_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<CopyChoices>();
  CLI::App* log = app.add_subcommand(
      "log", "Move a cell between a journal in a file and a log in an etcd cluster; run a member of that cluster.");
  log->require_subcommand(1);
  CLI::App* copying = log->add_subcommand(
      "copy", "Copy the durable facts of a cell whose boards have ended, with the replies that are remembered.");
  copying->add_option("FROM", choices->from, "A board's journal, or a log: etcd://A,B,C/CELL")->required();
  copying->add_option("TO", choices->to, "The other: a log of a cell that the cluster does not know, or a new file")
      ->required();
  add_log_options(*copying, choices->certificates, choices->insecure);
  copying->footer(
      help_footer("log copy cell.journal etcd://10.0.0.1,10.0.0.2,10.0.0.3/blocks --log-certificates certs"));
  copying->callback([choices, &status] { status = run_copy(*choices); });
  add_member_command(*log, status);
}

}  // namespace pizarra::programs
