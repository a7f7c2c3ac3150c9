#include "programs/commands/console_choices.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sys/stat.h>

#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

namespace {

constexpr std::size_t largest_certificate = 1 << 20;

Result<std::string> read_pem(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in && text.size() <= largest_certificate && text.find("-----BEGIN ") != std::string::npos) return text;
  return fail("bad-certificate", fmt::format("{} cannot be read as PEM", text_of_bytes(path)));
}

CLI::Validator ip_address_check() {
  const auto check = [](const std::string& text) {
    if (web::is_ip_address(text)) return std::string();
    return fmt::format("'{}' is no IP address, as 0.0.0.0 or ::; a port stands behind --port", text_of_bytes(text));
  };
  return {check, "ADDRESS"};
}

}  // namespace

Result<std::optional<console::Console::Abroad>> abroad_of(const ConsoleChoices& choices) {
  if (choices.listen.empty()) return std::nullopt;
  console::Console::Abroad abroad{choices.listen, choices.hosts, {}, {}, choices.keys};
  if (abroad.hosts.empty()) abroad.hosts = {choices.listen};
  const Result<std::string> certificate = read_pem(choices.certificate);
  if (!certificate) return fail(certificate);
  const Result<std::string> key = read_pem(choices.certificate_key);
  if (!key) return fail(key);
  struct stat status {};
  constexpr mode_t others = S_IRWXG | S_IRWXO;
  if (stat(choices.certificate_key.c_str(), &status) == 0 && (status.st_mode & others) != 0) {
    return fail("exposed-key", fmt::format("others may read {}: chmod 600 it", text_of_bytes(choices.certificate_key)));
  }
  abroad.certificate = *certificate;
  abroad.certificate_key = *key;
  return abroad;
}

void add_console_options(CLI::App& command, ConsoleChoices& choices) {
  command
      .add_option("CELL", choices.cell_file,
                  "The cell file: of the cell in this process, or, for its arm to be drawn, of the one that runs")
      ->check(CLI::ExistingFile);
  command.add_option("--port", choices.port, "The port on this host's loopback; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  CLI::Option* listen = command.add_option(
      "--listen", choices.listen,
      "An address of this host that other machines reach, as 0.0.0.0: by TLS alone, for who shows the token of a key");
  listen->check(ip_address_check());
  const auto abroad = [&](const char* name, auto& into, const char* help) {
    CLI::Option* option = command.add_option(name, into, help)->needs(listen);
    return option;
  };
  abroad("--host", choices.hosts, "A name or address by which browsers call it; may be given again; the first is said");
  listen->needs(abroad("--certificate", choices.certificate, "The certificate of that name, a PEM file"));
  listen->needs(abroad("--certificate-key", choices.certificate_key, "Its key, a PEM file that nobody else may read"));
  listen->needs(abroad("--keys", choices.keys, "The folder of the operators' secrets and tokens (keys token)"));
  command
      .add_option("--journal", choices.journal,
                  "The board's journal, if this machine has the file: what the servo did and the eyes saw is shown\n"
                  "from its beginning on; default: that of the cell that runs here")
      ->check(CLI::ExistingFile);
  command.add_option("--pictures", choices.pictures,
                     "The folder in which pictures of the past are kept; default: one that goes with the console");
  command.add_option("--pictures-mb", choices.pictures_mb, "How much of them at most; 0: none are kept")
      ->check(CLI::Range(0, 1'000'000))
      ->capture_default_str();
  command.add_option("--addresses", choices.addresses,
                     "A file, or a pipe that somebody reads, to which each address is added as a line");
  CLI::Option* foxglove =
      command.add_flag("--foxglove", choices.foxglove,
                       "Also speak the Foxglove WebSocket protocol, at an address that is said, to be read");
  command
      .add_option("--foxglove-origin", choices.foxglove_origins,
                  "An origin whose pages may connect for that, as https://app.foxglove.dev; may be given again")
      ->needs(foxglove);
  command.add_option("--seed", choices.seed, "What chance begins from")->check(seed_check())->capture_default_str();
  add_board_options(&command, choices.board);
}

}  // namespace pizarra::programs
