// `host join`: prepares this machine to be a host of a cell: a key of its own, and a service of systemd that runs `up`,
// also with a board that stands by and a member of the cell's log.

#include <filesystem>
#include <fmt/format.h>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/wire/keys.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/host/host_places.hpp"
#include "programs/host/host_service.hpp"
#include "programs/host/log_member.hpp"
#include "programs/host/member_place.hpp"
#include "programs/host/this_host.hpp"
#include "programs/host/up_choices.hpp"

namespace pizarra::programs {

namespace {

namespace files = std::filesystem;

struct JoinChoices {
  host::UpChoices up;  // what the service is to run
  std::string folder = wire::default_key_folder();
  std::string service_folder;
  bool force = false;
};

// Files that the service needs and that are not there.
std::vector<std::string> missing_certificates(const host::UpChoices& up, bool has_board) {
  if (up.certificates.empty()) return {};
  std::vector<std::string> needed = {"ca.crt"};
  if (!up.log_here.empty()) needed.insert(needed.end(), {"server.crt", "server.key"});
  if (has_board) needed.insert(needed.end(), {"client.crt", "client.key"});
  std::erase_if(needed, [&](const std::string& name) { return files::exists(up.certificates + "/" + name); });
  return needed;
}

Result<void> check_own_member(const host::UpChoices& up) {
  if (up.log_here.empty()) return {};
  const Result<cluster::LogAddress> log = cluster::LogAddress::from(up.log, up.certificates, up.log_insecure);
  if (!log) return fail(log);
  return host::check_member({*log, up.log_here, up.log_folder});
}

// The board of a log comes to itself with its host's key, too.
Result<void> check_join(const host::UpChoices& up, const forms::CellDescription& cell, const forms::CellHost& host) {
  if (up.log.empty() && host.name == cell.board_host) {
    return fail("bad-option", host.name + " has the cell's board: its keys are made with `keys new`");
  }
  if (up.log.empty()) return {};
  const Result<void> log = host::check_log(up, cell, host);
  return log ? check_own_member(up) : log;
}

// One that is there is kept: the board may know it already.
Result<void> make_key(const JoinChoices& choices, const std::string& secret) {
  if (files::exists(secret)) return {};
  const Result<wire::KeyPair> made = wire::make_keys(choices.folder, choices.up.host, {{"*"}, {"*"}, {"*"}, {}});
  return made ? Result<void>() : fail(made);
}

Result<void> make_all(const JoinChoices& choices, const std::string& secret, const host::HostService& service) {
  const Result<void> place = choices.force ? Result<void>() : host::check_place(service);
  if (!place) return place;
  const bool has_member = !choices.up.log_here.empty();
  const Result<void> folder = has_member ? host::make_member_folder(choices.up.log_folder) : Result<void>();
  if (!folder) return folder;
  const Result<void> key = make_key(choices, secret);
  return key ? host::write(service) : key;
}

int complain_of_join(const Failure& failure) {
  return complain(failure, failure.symbol == "cannot-write" ? exit_unavailable : exit_usage);
}

// What a person has to do yet.
void print_what_is_left(const host::UpChoices& up, const forms::CellDescription& cell, const std::string& secret,
                        const std::string& service) {
  const std::string base = secret.substr(0, secret.rfind('/') + 1);
  const bool has_board = up.host == cell.board_host || !up.standby.empty();
  fmt::print("{}{}.key  bring it to the {} folder of keys\n", text_of_bytes(base), up.host,
             up.log.empty() ? "board's" : "boards'");
  if (!files::exists(base + "board.key")) fmt::print("{}board.key  bring it here from there\n", text_of_bytes(base));
  if (has_board && !cell.board_keys.empty() && !files::exists(cell.board_keys + "/board.secret")) {
    fmt::print("{}  bring the boards' whole folder of keys here\n", text_of_bytes(cell.board_keys));
  }
  for (const std::string& name : missing_certificates(up, has_board)) {
    fmt::print("{}/{}  bring it here: a certificate of the log\n", text_of_bytes(host::full_path(up.certificates)),
               name);
  }
  fmt::print("{}  then: systemctl --user enable --now pizarra-{}\n", text_of_bytes(service), cell.name);
}

int run_join(const JoinChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.up.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<forms::CellHost> host = host::choose_host(*cell, choices.up.host);
  if (!host) return complain(host.error(), exit_usage);
  const Result<void> possible = check_join(choices.up, *cell, *host);
  if (!possible) return complain(possible.error(), exit_usage);
  const std::string secret = host::full_path(choices.folder + "/" + choices.up.host + ".secret");
  const host::HostService service = host::host_service(choices.up, cell->name, secret, choices.service_folder);
  const Result<void> made = make_all(choices, secret, service);
  if (!made) return complain_of_join(made.error());
  print_what_is_left(choices.up, *cell, secret, service.file);
  return exit_reached;
}

}  // namespace

void add_host_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<JoinChoices>();
  CLI::App* host = app.add_subcommand("host", "Prepare this machine to be a host of a cell.");
  host->require_subcommand(1);
  CLI::App* join = host->add_subcommand("join", "Make this host's key, and a systemd service that runs its agents.");
  join->add_option("CELL", choices->up.cell, "The cell file")->required()->check(CLI::ExistingFile);
  join->add_option("--host", choices->up.host, "The name of this host in the cell file")->required();
  join->add_option("--dir", choices->folder, "The folder of the key")->capture_default_str();
  join->add_option("--service-dir", choices->service_folder,
                   "The folder of the service; default: ~/.config/systemd/user");
  join->add_flag("--force", choices->force, "Replace a service of that name that is there with another text");
  host::add_log_options(*join, choices->up);
  join->footer(help_footer("host join two-hosts.scm --host desk"));
  join->callback([choices, &status] { status = run_join(*choices); });
}

}  // namespace pizarra::programs
