#include "programs/host/host_service.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <vector>

#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::host {

namespace {

namespace files = std::filesystem;

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
  add("--past", up.past.empty() ? "" : full_path(up.past));
  return words;
}

std::string text_of(const UpChoices& up, const std::string& cell_name, const std::string& secret) {
  std::string log;
  for (const std::string& word : log_words(up)) log += " " + argument_of_systemd(word);
  return fmt::format(
      "[Unit]\nDescription=Pizarra: the host {} of the cell {}\nAfter=network-online.target\n"
      "StartLimitIntervalSec=0\n\n"
      "[Service]\nEnvironment={}\nExecStart={} up {} --host {}{}\nRestart=on-failure\nRestartSec=2\n\n"
      "[Install]\nWantedBy=default.target\n",
      up.host, cell_name, word_of_systemd("PIZARRA_KEY=" + secret),
      word_of_systemd(programs::beside_this_program("pizarra-cell")), argument_of_systemd(full_path(up.cell)),
      argument_of_systemd(up.host), log);
}

}  // namespace

std::string full_path(const std::string& file) { return files::absolute(file).lexically_normal().string(); }

HostService host_service(const UpChoices& up, const std::string& cell_name, const std::string& secret,
                         const std::string& folder) {
  return {fmt::format("{}/pizarra-{}.service", folder.empty() ? default_service_folder() : folder, cell_name),
          text_of(up, cell_name, secret)};
}

Result<void> check_place(const HostService& service) {
  std::ifstream in(service.file);
  const std::string there{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || there == service.text) return {};
  return fail("exists", fmt::format("there is another service in {}: --force replaces it, --service-dir takes another "
                                    "folder",
                                    text_of_bytes(service.file)));
}

Result<void> write(const HostService& service) {
  const std::string folder = files::path(service.file).parent_path();
  std::error_code refused;
  files::create_directories(folder, refused);
  if (refused) {
    return fail("cannot-write", fmt::format("the folder of the service cannot be made: {}: {}", text_of_bytes(folder),
                                            refused.message()));
  }
  std::ofstream out(service.file);
  out << service.text << std::flush;
  if (out) return {};
  return fail("cannot-write",
              fmt::format("the service cannot be written: {}: {}", text_of_bytes(service.file), std::strerror(errno)));
}

}  // namespace pizarra::host
