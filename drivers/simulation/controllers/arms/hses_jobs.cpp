#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "drivers/arm/motoman/motoman_codes.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_emulator.hpp"
#include "lisp/result.hpp"

// Jobs that are selected and begun, and how long the controller and its arm have been at work.
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

HsesEmulator::Outcome HsesEmulator::select_job(const arm::HsesRequest& request) {
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
  if (job_runs_) return {.refusal = arm::motoman::operating};
  job_ = std::move(name);
  job_line_ = read.u32();
  return {};
}

std::uint16_t HsesEmulator::start_job() {
  const std::string* text = job_.empty() ? nullptr : files_.find(job_ + ".JBI");
  if (!text) return hses::job_not_found;
  if (job_runs_) return arm::motoman::operating;
  const Refusal refusal = cabinet_.refusal();
  // A public client begins its job as soon as the servos' switch is acknowledged.
  const bool waits = refusal == Refusal::servo_off && cabinet_.servo_comes_on();
  if (refusal != Refusal::none && !waits) return hses_code(refusal);
  Result<std::vector<Duration>> lines = read_motoman_job(*text);
  if (!lines) return hses::wrong_instruction;
  if (job_line_ >= lines->size()) job_line_ = 0;
  running_job_ = cabinet_.executor().spawn(run_job(std::move(*lines), job_line_));
  return 0;
}

Task<void> HsesEmulator::run_job(std::vector<Duration> lines, std::size_t from) {
  constexpr Duration look_again = 10ms;
  job_runs_ = true;
  while (cabinet_.servo_comes_on()) co_await sleep(cabinet_.executor(), look_again);
  for (std::size_t line = from; line < lines.size(); ++line) {
    job_line_ = static_cast<std::uint32_t>(line);
    if (lines[line] > Duration::zero()) co_await sleep(cabinet_.executor(), lines[line]);
  }
  job_runs_ = false;
}

// Since when, which it does not know, and how long.
HsesEmulator::Outcome HsesEmulator::management_time(const arm::HsesRequest& request) const {
  struct Kind {
    std::uint16_t instance;
    Duration ArmCabinet::WorkTimes::*time;
  };
  using Times = ArmCabinet::WorkTimes;
  constexpr Kind kinds_of_time[] = {{1, &Times::power},    {10, &Times::servo},   {11, &Times::servo},
                                    {110, &Times::motion}, {111, &Times::motion}, {210, &Times::motion},
                                    {211, &Times::motion}, {301, &Times::motion}};
  const auto* kind = std::ranges::find(kinds_of_time, request.instance, &Kind::instance);
  if (kind == std::end(kinds_of_time)) return {.refusal = arm::hses::wrong_instance};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(cabinet_.work_times().*(kind->time)).count();
  std::string since = "0000/00/00 00:00";
  std::string elapsed = fmt::format("{:06}:{:02}'{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return of_elements(request, {std::move(since), std::move(elapsed)});
}

}  // namespace pizarra::simulation
