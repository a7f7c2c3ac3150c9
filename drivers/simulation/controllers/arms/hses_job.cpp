#include "drivers/simulation/controllers/arms/hses_job.hpp"

#include <charconv>

namespace pizarra::simulation {

namespace {

std::optional<Duration> wait_of(std::string_view instruction) {
  constexpr std::string_view timer = "TIMER T=";
  constexpr double longest_s = 3600;
  if (instruction == "NOP" || instruction == "END" || instruction.starts_with('\'')) return Duration::zero();
  if (!instruction.starts_with(timer)) return std::nullopt;
  double seconds = 0;
  const char* begin = instruction.data() + timer.size();
  const auto [end, error] = std::from_chars(begin, instruction.data() + instruction.size(), seconds);
  const bool sound = error == std::errc() && seconds >= 0 && seconds <= longest_s;
  if (!sound) return std::nullopt;
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Result<std::vector<Duration>> read_motoman_job(std::string_view text) {
  std::vector<Duration> waits;
  bool among_instructions = false;
  bool ends = false;
  while (!text.empty() && !ends) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (line.ends_with('\r') || line.ends_with(' ')) line.remove_suffix(1);
    if (line == "//INST") among_instructions = true;
    if (!among_instructions || line.empty() || line.starts_with('/')) continue;
    const std::optional<Duration> wait = wait_of(line);
    if (!wait) return fail("bad-job", "the emulated controller knows no such instruction", to_datum(waits.size()));
    waits.push_back(*wait);
    ends = line == "END";
  }
  if (!ends) return fail("bad-job", "a job ends with END", to_datum(waits.size()));
  return waits;
}

}  // namespace pizarra::simulation
