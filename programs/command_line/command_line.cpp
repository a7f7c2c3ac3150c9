#include "programs/command_line/command_line.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <poll.h>
#include <string_view>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "lisp/nearest.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/exit_codes.hpp"

namespace pizarra::programs {

namespace {

std::string suggestion(const std::string& typed, const std::vector<std::string>& known) {
  const std::string near = nearest_name(typed, known);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

// The parser's second error after an unknown option is often only that option's value.
std::string unknown_option(const CLI::App& word) {
  for (const std::string& typed : word.remaining()) {
    if (!typed.starts_with("--")) continue;
    const std::string option = typed.substr(0, typed.find('='));
    std::vector<std::string> known;
    for (const CLI::Option* one : word.get_options()) known.push_back(one->get_name());
    const std::string whose = word.get_parent() == nullptr ? "there is" : word.get_name() + " has";
    return fmt::format("{} no option {}{}", whose, option, suggestion(option, known));
  }
  return {};
}

std::string unknown_command(const CLI::App& app) {
  const std::vector<std::string> typed = app.remaining();
  if (typed.empty()) return {};
  std::vector<std::string> known;
  for (const CLI::App* word : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(word->get_name());
  }
  if (known.empty()) return {};
  const std::string whose = app.get_parent() == nullptr ? "there is" : app.get_name() + " has";
  return fmt::format("{} no word {}{}", whose, typed.front(), suggestion(typed.front(), known));
}

// Replaces the words in which CLI11 refuses a file by those of our other sentences.
std::string in_our_words(std::string sentence) {
  constexpr std::pair<std::string_view, std::string_view> ours[] = {
      {"File does not exist: ", "there is no file "},
      {"File is actually a directory: ", "this is a folder, not a file: "}};
  for (const auto& [theirs, words] : ours) {
    const std::size_t at = sentence.find(theirs);
    if (at != std::string::npos) sentence.replace(at, theirs.size(), words);
  }
  return sentence;
}

// What was wrong, as one line.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  std::vector<const CLI::App*> stumbled{&app};
  for (const CLI::App* word : app.get_subcommands()) stumbled.push_back(word);
  for (const CLI::App* word : stumbled) {
    std::string unknown = unknown_option(*word);
    if (!unknown.empty()) return unknown;
  }
  const bool has_word = !app.get_subcommands().empty();
  std::string sentence = unknown_command(*stumbled.back());
  if (sentence.empty()) sentence = in_our_words(error.what());
  for (std::size_t end = sentence.find('\n'); end != std::string::npos; end = sentence.find('\n')) {
    sentence.replace(end, 1, end + 1 == sentence.size() ? "" : "; ");
  }
  if (sentence.ends_with("?")) return sentence;
  const std::string word = has_word ? " " + app.get_subcommands().front()->get_name() : std::string();
  return fmt::format("{}; {}{} --help says more", sentence, app.get_name(), word);
}

void on_unread(int) { _exit(exit_interrupted); }

bool output_is_unread() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

// The last output may still be in a buffer; what could not be written before is known to the stream, but not why.
int status_of_output(int status) {
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0) return status;
  if (output_is_unread()) return std::max<int>(status, exit_interrupted);
  const std::string reason = write(STDOUT_FILENO, "\n", 1) < 0 ? std::strerror(errno) : "a part of it is missing";
  fmt::print(stderr, "pizarra: cannot write standard output whole: {}\n", reason);
  return std::max<int>(status, exit_unavailable);
}

}  // namespace

int run_program(CLI::App& app, int argc, char** argv, const int& status) {
  std::signal(SIGPIPE, on_unread);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return status_of_output(end_of_parsing(app, error));
  } catch (const std::system_error&) {
    // So fmt says that the stream takes no more; any other has not been told.
    if (std::ferror(stdout) == 0) throw;
  }
  return status_of_output(status);
}

int end_of_parsing(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  fmt::print(stderr, "{}: {}\n", app.get_name(), text_of_bytes(complaint_of(app, error)));
  return exit_usage;
}

}  // namespace pizarra::programs
