#include "agents/launcher/words.hpp"

#include <charconv>
#include <fmt/format.h>

#include "lisp/nearest.hpp"

namespace pizarra {

int complain(const Failure& failure, ExitCode code) {
  fmt::print(stderr, "pizarra: {}\n", describe(failure));
  return code;
}

CLI::Validator seed_check() {
  const auto check = [](const std::string& text) {
    std::uint64_t seed = 0;
    const char* end = text.data() + text.size();
    const auto [read_to, error] = std::from_chars(text.data(), end, seed);
    if (error == std::errc() && read_to == end) return std::string();
    return fmt::format("a seed is a whole number from 0 to 18446744073709551615, not {}", text);
  };
  return {check, "SEED"};
}

namespace {

std::string suggestion(const std::string& typed, const std::vector<std::string>& known) {
  const std::string near = nearest_name(typed, known);
  return near.empty() ? std::string() : fmt::format("; did you mean {}?", near);
}

// What the parser stumbles on after an unknown option is often only that option's value.
std::string unknown_option(const CLI::App& word) {
  for (const std::string& typed : word.remaining()) {
    if (!typed.starts_with("--")) continue;
    const std::string option = typed.substr(0, typed.find('='));
    std::vector<std::string> known;
    for (const CLI::Option* one : word.get_options()) known.push_back(one->get_name());
    return fmt::format("{} has no option {}{}", word.get_name(), option, suggestion(option, known));
  }
  return {};
}

std::string unknown_word(const CLI::App& app) {
  const std::vector<std::string> typed = app.remaining();
  if (typed.empty()) return {};
  std::vector<std::string> known;
  for (const CLI::App* word : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(word->get_name());
  }
  const std::string kind = typed.front().starts_with("-") ? "option" : "word";
  return fmt::format("there is no {} {}{}", kind, typed.front(), suggestion(typed.front(), known));
}

// What was wrong, as one line.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  for (const CLI::App* word : app.get_subcommands()) {
    const std::string unknown = unknown_option(*word);
    if (!unknown.empty()) return unknown;
  }
  const bool has_word = !app.get_subcommands().empty();
  std::string sentence = has_word ? std::string() : unknown_word(app);
  if (sentence.empty()) sentence = error.what();
  for (std::size_t end = sentence.find('\n'); end != std::string::npos; end = sentence.find('\n')) {
    sentence.replace(end, 1, end + 1 == sentence.size() ? "" : "; ");
  }
  if (sentence.ends_with("?")) return sentence;
  const std::string word = has_word ? " " + app.get_subcommands().front()->get_name() : std::string();
  return fmt::format("{}; pizarra{} --help says more", sentence, word);
}

}  // namespace

int end_of_parsing(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  fmt::print(stderr, "pizarra: {}\n", complaint_of(app, error));
  return exit_usage;
}

std::string counted(std::size_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string shipped_file(const std::string& path) { return std::string(PIZARRA_SOURCE_DIR) + "/" + path; }

}  // namespace pizarra
