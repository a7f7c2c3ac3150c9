// `log copy`: a cell's durable facts from the journal in a file to a log in an etcd cluster, or back.

#include <fmt/format.h>
#include <thread>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/cluster/transfer.hpp"
#include "blackboard/server/sessions.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/kept_journal.hpp"

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

}  // namespace

void add_log_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<CopyChoices>();
  CLI::App* log = app.add_subcommand("log", "Move a cell between a journal in a file and a log in an etcd cluster.");
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
}

}  // namespace pizarra::programs
