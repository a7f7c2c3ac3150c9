// `host join`: prepares this machine to be a host of a cell: a key of its own, and a service of systemd that runs `up`,
// also with a board that stands by and a member of the cell's log.

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "blackboard/cluster/log_address.hpp"
#include "blackboard/wire/keys.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/host_places.hpp"
#include "programs/commands/log_member.hpp"
#include "programs/commands/this_host.hpp"
#include "programs/commands/up_choices.hpp"

namespace pizarra::programs {

namespace {

namespace files = std::filesystem;

struct JoinChoices {
  UpChoices up;  // what the service is to run
  std::string folder = wire::default_key_folder();
  std::string service;
};

std::string full_path(const std::string& file) { return files::absolute(file).lexically_normal().string(); }

std::string default_service_folder() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  const std::string base = config != nullptr ? config : std::string(home == nullptr ? "" : home) + "/.config";
  return base + "/systemd/user";
}

// Of systemd: `%` begins a specifier, and a word with blanks is quoted. In the arguments of a program, and there alone,
// `$` begins a variable.
std::string word_of_systemd(const std::string& word, std::string_view doubled = "%") {
  std::string text;
  for (const char c : word) {
    if (doubled.find(c) != std::string_view::npos) text += c;
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return '"' + text + '"';
}

std::string argument_of_systemd(const std::string& word) { return word_of_systemd(word, "%$"); }

// The options of the log, as one types them after `up`.
std::vector<std::string> log_words(const UpChoices& up) {
  std::vector<std::string> words;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--log", up.log);
  add("--log-certificates", up.certificates.empty() ? "" : full_path(up.certificates));
  if (up.log_insecure) words.emplace_back("--log-insecure");
  add("--log-here", up.log_here);
  add("--log-folder", up.log_folder.empty() ? "" : full_path(up.log_folder));
  add("--standby", up.standby);
  return words;
}

std::string service_of(const UpChoices& up, const std::string& cell_name, const std::string& secret) {
  std::string log;
  for (const std::string& word : log_words(up)) log += " " + argument_of_systemd(word);
  return fmt::format(
      "[Unit]\nDescription=Pizarra: the host {} of the cell {}\nAfter=network-online.target\n"
      "StartLimitIntervalSec=0\n\n"
      "[Service]\nEnvironment={}\nExecStart={} up {} --host {}{}\nRestart=on-failure\nRestartSec=2\n\n"
      "[Install]\nWantedBy=default.target\n",
      up.host, cell_name, word_of_systemd("PIZARRA_KEY=" + secret),
      word_of_systemd(beside_this_program("pizarra-cell")), argument_of_systemd(full_path(up.cell)),
      argument_of_systemd(up.host), log);
}

// Files that the service needs and that are not there.
std::vector<std::string> missing_certificates(const UpChoices& up, bool has_board) {
  if (up.certificates.empty()) return {};
  std::vector<std::string> needed = {"ca.crt"};
  if (!up.log_here.empty()) needed.insert(needed.end(), {"server.crt", "server.key"});
  if (has_board) needed.insert(needed.end(), {"client.crt", "client.key"});
  std::erase_if(needed, [&](const std::string& name) { return files::exists(up.certificates + "/" + name); });
  return needed;
}

// For the member's data, the user's alone: etcd refuses others.
Result<void> make_log_folder(const UpChoices& up) {
  if (up.log_here.empty()) return {};
  std::error_code refused;
  const bool made = files::create_directories(up.log_folder, refused);
  if (made) files::permissions(up.log_folder, files::perms::owner_all, refused);
  if (!refused) return {};
  return fail("cannot-write", "the member's folder cannot be made: " + text_of_bytes(up.log_folder));
}

Result<void> check_own_member(const UpChoices& up) {
  if (up.log_here.empty()) return {};
  const Result<cluster::LogAddress> log = cluster::LogAddress::from(up.log, up.certificates, up.log_insecure);
  if (!log) return fail(log);
  return check_member({*log, up.log_here, up.log_folder});
}

// The board of a log comes to itself with its host's key, too.
Result<void> check_join(const UpChoices& up, const forms::CellDescription& cell, const forms::CellHost& host) {
  if (up.log.empty() && host.name == cell.board_host) {
    return fail("bad-option", host.name + " has the cell's board: its keys are made with `keys new`");
  }
  if (up.log.empty()) return {};
  const Result<void> log = check_log(up, cell, host);
  return log ? check_own_member(up) : log;
}

// One that is there is kept: the board may know it already.
Result<std::string> key_of(const JoinChoices& choices) {
  const std::string secret = full_path(choices.folder + "/" + choices.up.host + ".secret");
  if (files::exists(secret)) return secret;
  const Result<wire::KeyPair> made = wire::make_keys(choices.folder, choices.up.host, {{"*"}, {"*"}, {"*"}, {}});
  if (!made) return fail(made);
  return secret;
}

Result<std::string> write_service(const JoinChoices& choices, const std::string& cell_name, const std::string& secret) {
  const std::string folder = choices.service.empty() ? default_service_folder() : choices.service;
  std::error_code refused;
  files::create_directories(folder, refused);
  std::string service = fmt::format("{}/pizarra-{}.service", folder, cell_name);
  std::ofstream out(service);
  out << service_of(choices.up, cell_name, secret) << std::flush;
  if (!out) return fail("cannot-write", "the service cannot be written: " + text_of_bytes(service));
  return service;
}

int complain_of_join(const Failure& failure) {
  return complain(failure, failure.symbol == "cannot-write" ? exit_unavailable : exit_usage);
}

// What a person has to do yet.
void print_what_is_left(const UpChoices& up, const forms::CellDescription& cell, const std::string& secret,
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
    fmt::print("{}/{}  bring it here: a certificate of the log\n", text_of_bytes(full_path(up.certificates)), name);
  }
  fmt::print("{}  then: systemctl --user enable --now pizarra-{}\n", text_of_bytes(service), cell.name);
}

int run_join(const JoinChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.up.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<forms::CellHost> host = choose_host(*cell, choices.up.host);
  if (!host) return complain(host.error(), exit_usage);
  const Result<void> possible = check_join(choices.up, *cell, *host);
  if (!possible) return complain(possible.error(), exit_usage);
  const Result<std::string> secret = key_of(choices);
  if (!secret) return complain_of_join(secret.error());
  const Result<void> folder = make_log_folder(choices.up);
  if (!folder) return complain_of_join(folder.error());
  const Result<std::string> service = write_service(choices, cell->name, *secret);
  if (!service) return complain_of_join(service.error());
  print_what_is_left(choices.up, *cell, *secret, *service);
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
  join->add_option("--service-dir", choices->service, "The folder of the service; default: ~/.config/systemd/user");
  add_log_options(*join, choices->up);
  join->footer(help_footer("host join two-hosts.scm --host desk"));
  join->callback([choices, &status] { status = run_join(*choices); });
}

}  // namespace pizarra::programs
