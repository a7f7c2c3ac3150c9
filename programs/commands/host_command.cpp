// `host join`: prepares this machine to be a host of a cell: a key of its own, and a service of systemd that runs `up`.

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "blackboard/wire/keys.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/this_host.hpp"

namespace pizarra::programs {

namespace {

namespace files = std::filesystem;

struct JoinChoices {
  std::string cell;
  std::string host;
  std::string folder = wire::default_key_folder();
  std::string service;
};

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

std::string service_of(const JoinChoices& choices, const std::string& cell_name, const std::string& secret) {
  const std::string cell = files::absolute(choices.cell).lexically_normal().string();
  return fmt::format(
      "[Unit]\nDescription=Pizarra: the host {} of the cell {}\nAfter=network-online.target\n"
      "StartLimitIntervalSec=0\n\n"
      "[Service]\nEnvironment={}\nExecStart={} up {} --host {}\nRestart=on-failure\nRestartSec=2\n\n"
      "[Install]\nWantedBy=default.target\n",
      choices.host, cell_name, word_of_systemd("PIZARRA_KEY=" + secret),
      word_of_systemd(beside_this_program("pizarra-cell")), argument_of_systemd(cell),
      argument_of_systemd(choices.host));
}

// One that is there is kept: the board may know it already.
Result<std::string> key_of(const JoinChoices& choices) {
  const std::string secret =
      files::absolute(choices.folder + "/" + choices.host + ".secret").lexically_normal().string();
  if (files::exists(secret)) return secret;
  const Result<wire::KeyPair> made = wire::make_keys(choices.folder, choices.host, {{"*"}, {"*"}, {"*"}, {}});
  if (!made) return fail(made);
  return secret;
}

int run_join(const JoinChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain(cell.error(), exit_usage);
  const Result<forms::CellHost> host = choose_host(*cell, choices.host);
  if (!host) return complain(host.error(), exit_usage);
  if (host->name == cell->board_host) {
    return complain({"bad-option", host->name + " has the cell's board: its keys are made with `keys new`", {}, {}},
                    exit_usage);
  }
  const Result<std::string> secret = key_of(choices);
  if (!secret) return complain(secret.error(), secret.error().symbol == "cannot-write" ? exit_unavailable : exit_usage);
  const std::string folder = choices.service.empty() ? default_service_folder() : choices.service;
  std::error_code refused;
  files::create_directories(folder, refused);
  const std::string service = fmt::format("{}/pizarra-{}.service", folder, cell->name);
  std::ofstream out(service);
  out << service_of(choices, cell->name, *secret) << std::flush;
  if (!out) {
    return complain({"cannot-write", "the service cannot be written: " + text_of_bytes(service), {}, {}},
                    exit_unavailable);
  }
  const std::string base = secret->substr(0, secret->rfind('/') + 1);
  fmt::print("{}{}.key  bring it to the board's folder of keys\n", text_of_bytes(base), choices.host);
  if (!files::exists(base + "board.key")) fmt::print("{}board.key  bring it here from there\n", text_of_bytes(base));
  fmt::print("{}  then: systemctl --user enable --now pizarra-{}\n", text_of_bytes(service), cell->name);
  return exit_reached;
}

}  // namespace

void add_host_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<JoinChoices>();
  CLI::App* host = app.add_subcommand("host", "Prepare this machine to be a host of a cell.");
  host->require_subcommand(1);
  CLI::App* join = host->add_subcommand("join", "Make this host's key, and a systemd service that runs its agents.");
  join->add_option("CELL", choices->cell, "The cell file")->required()->check(CLI::ExistingFile);
  join->add_option("--host", choices->host, "The name of this host in the cell file")->required();
  join->add_option("--dir", choices->folder, "The folder of the key")->capture_default_str();
  join->add_option("--service-dir", choices->service, "The folder of the service; default: ~/.config/systemd/user");
  join->footer(help_footer("host join two-hosts.scm --host desk"));
  join->callback([choices, &status] { status = run_join(*choices); });
}

}  // namespace pizarra::programs
