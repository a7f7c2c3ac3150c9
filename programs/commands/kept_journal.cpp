#include "programs/commands/kept_journal.hpp"

#include "blackboard/cluster/cluster_log.hpp"
#include "blackboard/cluster/etcd_client.hpp"

namespace pizarra::programs {

namespace {

std::string check_where(const std::string& text) {
  return cluster::LogAddress::is_one(text) ? std::string() : CLI::ExistingFile(text);
}

Result<journal::PlayedBack> read(const KeptJournal& journal, store::Store& store, const Moment& until) {
  const Result<OpenLog> log = open_log(journal);
  if (!log) return fail(log);
  const Result<std::optional<std::uint64_t>> head = cluster::head_of(*log->key_values, log->keys);
  if (!head) return fail(head);
  if (!*head) return fail("bad-journal", "the cluster has no log of this cell: " + journal.where);
  Result<journal::PlayedBack> played =
      journal::check_reached(cluster::read_log(*log->key_values, log->keys, store, until), until);
  if (!played) return fail(played);
  played->lacks = Failure{"gap",
                          "the log of boards that take over has only what is durable: a board's journals in its folder "
                          "--past have the rest",
                          {},
                          {}};
  return played;
}

}  // namespace

void add_log_options(CLI::App& command, std::string& certificates, bool& insecure) {
  command
      .add_option("--log-certificates", certificates,
                  "The folder of ca.crt, client.crt and client.key for a log that is not on this machine")
      ->type_name("DIR");
  command.add_flag("--log-insecure", insecure, "Speak to a log that is not on this machine unencrypted");
}

void add_kept_journal(CLI::App& command, KeptJournal& journal, const std::string& help) {
  command.add_option("FILE", journal.where, help)->required()->check(check_where);
  add_log_options(command, journal.certificates, journal.insecure);
}

Result<OpenLog> open_log(const KeptJournal& journal) {
  const Result<cluster::LogAddress> address =
      cluster::LogAddress::from(journal.where, journal.certificates, journal.insecure);
  if (!address) return fail(address);
  Result<std::unique_ptr<cluster::EtcdClient>> client = cluster::EtcdClient::open(*address);
  if (!client) return fail(client);
  // A member that does not answer is left for the next one.
  Result<std::optional<std::string>> answered = fail("unavailable", "");
  const cluster::LogKeys keys(address->cell);
  for (std::size_t asked = 0; asked < address->members.size() && !answered; ++asked) {
    answered = cluster::get(**client, keys.head());
  }
  if (!answered) return fail(answered);
  return OpenLog{std::move(*client), keys};
}

Result<journal::LineStart> end_of(const KeptJournal& journal) {
  if (!cluster::LogAddress::is_one(journal.where)) return journal::end_of_journal(journal.where);
  store::Store store;
  const Result<journal::PlayedBack> played = read(journal, store, {});
  if (!played) return fail(played);
  return played->to;
}

Result<std::unique_ptr<memory::RecordedBoard>> open_recorded(Executor& executor, const KeptJournal& journal,
                                                             const Moment& until) {
  if (!cluster::LogAddress::is_one(journal.where)) {
    return memory::RecordedBoard::open(executor, journal.where, until);
  }
  auto store = std::make_unique<store::Store>();
  Result<journal::PlayedBack> played = read(journal, *store, until);
  if (!played) return fail(played);
  return memory::RecordedBoard::of(executor, std::move(store), std::move(*played));
}

}  // namespace pizarra::programs
