#include "drivers/simulation/controllers/arms/hses_jobs.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include "blackboard/time/clock.hpp"
#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

namespace {

// How long an instruction takes; none of one that is not understood.
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

// A job as its file has it: what each instruction waits. Understood are NOP, END, comments and TIMER; a job with other
// instructions is not begun. Failure: bad-job, the line's number among the instructions as its subject.
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

}  // namespace

HsesOutcome HsesJobs::select(const arm::HsesRequest& request) {
  constexpr std::uint16_t in_execution = 1;
  constexpr std::uint16_t first_master = 10;
  constexpr std::uint16_t last_master = 15;
  constexpr std::size_t name_size = 32;
  const std::uint16_t to = request.instance;
  if (to != in_execution && (to < first_master || to > last_master)) return {.refusal = arm::hses::wrong_instance};
  if (request.service != arm::hses::set_all) return {.refusal = arm::hses::undefined_command};
  if (request.attribute != 0) return {.refusal = arm::hses::wrong_attribute};
  if (request.data.size() != name_size + 4) return {.refusal = arm::hses::wrong_size};
  line::OctetReader read(request.data, line::ByteOrder::little);
  std::string name(read.text(name_size));
  name.resize(std::min(name.find('\0'), name.size()));
  if (!files_.find(name + ".JBI")) return {.refusal = hses::job_not_found};
  if (runs_) return {.refusal = arm::motoman::operating};
  name_ = std::move(name);
  line_ = read.u32();
  return {};
}

std::uint16_t HsesJobs::start() {
  const std::string* text = name_.empty() ? nullptr : files_.find(name_ + ".JBI");
  if (!text) return hses::job_not_found;
  if (runs_) return arm::motoman::operating;
  const Refusal refusal = cabinet_.refusal();
  // A public client begins its job as soon as the servos' switch is acknowledged.
  const bool waits = refusal == Refusal::servo_off && cabinet_.servo_comes_on();
  if (refusal != Refusal::none && !waits) return hses_code(refusal);
  Result<std::vector<Duration>> lines = read_motoman_job(*text);
  if (!lines) return hses::wrong_instruction;
  if (line_ >= lines->size()) line_ = 0;
  running_ = cabinet_.executor().spawn(run(std::move(*lines), line_));
  return 0;
}

void HsesJobs::end() {
  running_ = Job();
  runs_ = false;
}

Task<void> HsesJobs::run(std::vector<Duration> lines, std::size_t from) {
  constexpr Duration look_again = 10ms;
  runs_ = true;
  while (cabinet_.servo_comes_on()) co_await sleep(cabinet_.executor(), look_again);
  for (std::size_t line = from; line < lines.size(); ++line) {
    line_ = static_cast<std::uint32_t>(line);
    if (lines[line] > Duration::zero()) co_await sleep(cabinet_.executor(), lines[line]);
  }
  runs_ = false;
}

}  // namespace pizarra::simulation
