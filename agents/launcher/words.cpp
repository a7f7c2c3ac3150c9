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

int end_of_parsing(const CLI::App& app, const CLI::ParseError& error) {
  // What the parser stumbles on after an unknown option is often only that option's value.
  for (const CLI::App* word : app.get_subcommands()) {
    for (const std::string& typed : word->remaining()) {
      if (!typed.starts_with("--")) continue;
      const std::string option = typed.substr(0, typed.find('='));
      std::vector<std::string> known;
      for (const CLI::Option* one : word->get_options()) known.push_back(one->get_name());
      const std::string near = nearest_name(option, known);
      fmt::print(stderr, "pizarra: {} has no option {}{}\n", word->get_name(), option,
                 near.empty() ? "" : fmt::format("; did you mean {}?", near));
      return exit_usage;
    }
  }
  return app.exit(error) == 0 ? exit_reached : exit_usage;
}

std::string shipped_file(const std::string& path) { return std::string(PIZARRA_SOURCE_DIR) + "/" + path; }

}  // namespace pizarra
