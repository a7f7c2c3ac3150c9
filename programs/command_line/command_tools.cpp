#include "programs/command_line/command_tools.hpp"

#include <charconv>
#include <filesystem>
#include <fmt/format.h>

namespace pizarra::programs {

int complain(const Failure& failure, ExitCode code) {
  fmt::print(stderr, "pizarra: {}\n", describe(failure));
  return code;
}

std::string help_footer(std::string_view example, std::string_view exit_codes) {
  return fmt::format("Example:\n  ./pizarra {}\n\n{}", example, exit_codes);
}

std::string version() { return "pizarra " PIZARRA_VERSION; }

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

CLI::Validator number_check(double least, double most) {
  const auto check = [least, most](const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [read_to, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && read_to == end && number >= least && number <= most) return std::string();
    return fmt::format("a number from {:g} to {:g} is wanted, not {}", least, most, text);
  };
  return {check, fmt::format("[{:g} - {:g}]", least, most)};
}

std::string counted(std::size_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string beside_this_program(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace pizarra::programs
