#include "drivers/ptu/ptu_driver.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/line/device_at.hpp"
#include "drivers/line/printable.hpp"

namespace pizarra::ptu {

PtuDriver::PtuDriver(Executor& executor, line::ByteWire& wire, PtuDirections directions)
    : executor_(executor),
      wire_(wire),
      device_(line::device_at("the pan-tilt unit", wire.place())),
      lines_(wire, line::frame_of_line),
      pan_{.letter = 'P', .name = "pan", .way = directions.pan_reversed ? -1.0 : 1.0},
      tilt_{.letter = 'T', .name = "tilt", .way = directions.tilt_reversed ? -1.0 : 1.0},
      why_lost_(device_ + " is not connected"),
      turns_(executor) {}

void PtuDriver::close() {
  connected_ = false;
  wire_.close();
}

std::unexpected<Failure> PtuDriver::lose(Failure why) {
  connected_ = false;
  why_lost_ = why.sentence;
  return fail(std::move(why));
}

std::unexpected<Failure> PtuDriver::not_understood(std::string_view command, std::string_view said) const {
  return fail("bad-reply", fmt::format("{} answered {} with \"{}\"", device_, command, line::printable(said)));
}

// Sends a command and answers what the unit says to it, without its star.
Task<Result<std::string>> PtuDriver::exchange(std::string command, Duration patience) {
  const Result<void> sent = wire_.write(command + " ");
  if (!sent) co_return lose(sent.error());
  const Time deadline = executor_.now() + patience;
  while (true) {
    const Result<std::string> line = co_await lines_.next(deadline);
    if (!line && line.error().symbol == "timeout") {
      const std::string sentence = fmt::format("{} did not answer {}", device_, command);
      co_return lose({"no-answer", sentence, {}, {}});
    }
    if (!line) co_return lose(line.error());
    if (!line::is_printable(*line)) co_return lose(not_understood(command, *line).error());
    const PtuLine said = read_ptu_line(*line);
    const bool its_own = said.echo == command;
    if (said.result == PtuLine::Result::none) {
      if (said.pan_hit || said.tilt_hit || its_own) continue;
      co_return lose(not_understood(command, *line).error());
    }
    if (echoes_ && said.echo.empty() && said.pan_hit && said.tilt_hit) {
      co_return lose({"restarted", device_ + " was without power and has reset itself", {}, {}});
    }
    // The late answer to a command that nobody waits for any more.
    if (echoes_ && !its_own) continue;
    if (!said.echo.empty() && !its_own) co_return lose(not_understood(command, *line).error());
    if (said.result == PtuLine::Result::ok) co_return said.text;
    co_return fail("refused", fmt::format("{} refused {}: {}", device_, command, line::printable(said.text)));
  }
}

Task<Result<std::string>> PtuDriver::answer_to(std::string command, Duration patience) {
  const Turns::Turn turn = co_await turns_.take();
  if (!connected_) co_return fail("disconnected", why_lost_);
  Result<std::string> answer = co_await exchange(std::move(command), patience);
  co_return answer;
}

Task<Result<void>> PtuDriver::command(std::string command, Duration patience) {
  const Result<std::string> answer = co_await answer_to(std::move(command), patience);
  if (!answer) co_return fail(answer);
  co_return Result<void>();
}

Task<Result<PanTiltRange>> PtuDriver::connect() {
  const Turns::Turn turn = co_await turns_.take();
  Result<PanTiltRange> connected = co_await connect_in_turn();
  co_return connected;
}

Task<Result<PanTiltRange>> PtuDriver::connect_in_turn() {
  connected_ = false;
  const Time deadline = executor_.now() + opening_time;
  const Result<void> open = co_await wire_.open(deadline);
  if (!open) co_return fail(open);
  const Result<void> quiet = co_await quieten();
  if (!quiet) co_return fail(quiet);
  const Result<void> set = co_await set_up();
  if (!set) co_return fail(set);
  const Result<void> pan = co_await ask_axis(pan_);
  if (!pan) co_return fail(pan);
  const Result<void> tilt = co_await ask_axis(tilt_);
  if (!tilt) co_return fail(tilt);
  connected_ = true;
  const PanTiltRange range{range_of(pan_), range_of(tilt_)};
  co_return range;
}

// Throws away what was said before anybody listened.
Task<Result<void>> PtuDriver::quieten() {
  lines_.clear();
  const Time enough = executor_.now() + longest_noise;
  while (executor_.now() < enough) {
    const Time quiet = executor_.now() + quiet_time;
    const Result<std::string> noise = co_await wire_.read(quiet);
    if (noise) continue;
    if (noise.error().symbol != "timeout") co_return fail(noise);
    co_return Result<void>();
  }
  co_return fail("bad-reply", "the line of " + device_ + " is never quiet");
}

// Half a command that another has left on the line spoils the first of ours, which may therefore be refused.
Task<Result<void>> PtuDriver::set_up() {
  echoes_ = false;
  const Result<std::string> first = co_await exchange("EE", answer_time);
  const bool spoilt = !first && first.error().symbol != "refused" && first.error().symbol != "bad-reply";
  if (spoilt) co_return fail(first);
  const Result<void> quiet = co_await quieten();
  if (!quiet) co_return quiet;
  const Result<void> asked = wire_.write("V ");
  if (!asked) co_return asked;
  const Time deadline = executor_.now() + answer_time;
  const Result<std::string> version = co_await lines_.next(deadline);
  if (!version) co_return fail("no-answer", device_ + " did not answer V");
  echoes_ = read_ptu_line(*version).echo == "V";
  // Where somebody who is gone has sent it, it goes no further.
  const Result<std::string> halted = co_await exchange("H", answer_time);
  if (!halted) co_return fail(halted);
  const Result<std::string> immediate = co_await exchange("I", answer_time);
  if (!immediate) co_return fail(immediate);
  co_return Result<void>();
}

Task<Result<double>> PtuDriver::ask(Axis& axis, char what) {
  const std::string question{axis.letter, what};
  const Result<std::string> answer = co_await exchange(question, answer_time);
  if (!answer) co_return fail(answer);
  const std::optional<double> number = first_number(*answer);
  if (!number) co_return lose(not_understood(question, *answer).error());
  co_return *number;
}

Task<Result<void>> PtuDriver::ask_axis(Axis& axis) {
  const Result<double> arc_seconds = co_await ask(axis, 'R');
  if (!arc_seconds) co_return fail(arc_seconds);
  const Result<double> low = co_await ask(axis, 'N');
  if (!low) co_return fail(low);
  const Result<double> high = co_await ask(axis, 'X');
  if (!high) co_return fail(high);
  const Result<double> slowest = co_await ask(axis, 'L');
  if (!slowest) co_return fail(slowest);
  const Result<double> fastest = co_await ask(axis, 'U');
  if (!fastest) co_return fail(fastest);
  constexpr double coarsest = 36000;  // ten degrees a count
  const bool sound =
      *arc_seconds > 0 && *arc_seconds < coarsest && *low < *high && *slowest >= 0 && *slowest < *fastest;
  if (!sound) {
    const std::string sentence = fmt::format("{} says of its {}: {} arc seconds a count, {} to {}, {} to {} counts/s",
                                             device_, axis.name, *arc_seconds, *low, *high, *slowest, *fastest);
    co_return fail("bad-reply", sentence, Datum::symbol(axis.name));
  }
  axis.deg_per_count = *arc_seconds / 3600;
  axis.low = *low;
  axis.high = *high;
  axis.slowest = *slowest;
  axis.fastest = *fastest;
  co_return Result<void>();
}

PanTiltAxisRange PtuDriver::range_of(const Axis& axis) const {
  const double one = axis.way * axis.low * axis.deg_per_count;
  const double other = axis.way * axis.high * axis.deg_per_count;
  return {std::min(one, other), std::max(one, other), axis.deg_per_count, axis.fastest * axis.deg_per_count};
}

Task<Result<void>> PtuDriver::move_to(PanTiltAxis which, double deg) {
  Axis& axis = axis_of(which);
  const Datum subject = Datum::symbol(axis.name);
  if (!connected_) co_return fail("disconnected", why_lost_, subject);
  if (!std::isfinite(deg))
    co_return fail("not-finite", fmt::format("the {} angle is not a number", axis.name), subject);
  const double count = std::round(axis.way * deg / axis.deg_per_count);
  if (count < axis.low || count > axis.high) {
    const PanTiltAxisRange range = range_of(axis);
    const std::string sentence = fmt::format("the unit's {} goes from {:.2f} to {:.2f} degrees, not to {:.2f}",
                                             axis.name, range.low_deg, range.high_deg, deg);
    co_return fail("out-of-range", sentence, subject);
  }
  std::string order = fmt::format("{}P{:.0f}", axis.letter, count + 0.0);
  Result<void> done = co_await command(std::move(order), answer_time);
  co_return done;
}

Task<Result<void>> PtuDriver::set_speed(PanTiltAxis which, double part) {
  Axis& axis = axis_of(which);
  if (!(part >= 0 && part <= 1)) {
    co_return fail("out-of-range", "a speed is a part from 0 to 1 of the unit's", Datum::symbol(axis.name));
  }
  const double counts = std::max(axis.slowest, std::round(part * axis.fastest));
  std::string order = fmt::format("{}S{:.0f}", axis.letter, counts);
  Result<void> done = co_await command(std::move(order), answer_time);
  co_return done;
}

Task<Result<void>> PtuDriver::halt() { return command("H", answer_time); }

Task<Result<void>> PtuDriver::reset(PanTiltAxis axis) {
  return command(axis == PanTiltAxis::pan ? "RP" : "RT", reset_time);
}

Task<Result<void>> PtuDriver::reset_all() { return command("R", reset_time); }

Task<Result<PanTiltReading>> PtuDriver::read() {
  const Turns::Turn turn = co_await turns_.take();
  if (!connected_) co_return fail("disconnected", why_lost_);
  const Result<double> pan = co_await ask(pan_, 'P');
  if (!pan) co_return fail(pan);
  const Result<double> tilt = co_await ask(tilt_, 'P');
  if (!tilt) co_return fail(tilt);
  const Result<double> pan_target = co_await ask(pan_, 'O');
  if (!pan_target) co_return fail(pan_target);
  const Result<double> tilt_target = co_await ask(tilt_, 'O');
  if (!tilt_target) co_return fail(tilt_target);
  PanTiltReading reading{};
  reading.pan_deg = pan_.way * *pan * pan_.deg_per_count;
  reading.tilt_deg = tilt_.way * *tilt * tilt_.deg_per_count;
  reading.moving = *pan != *pan_target || *tilt != *tilt_target;
  co_return reading;
}

}  // namespace pizarra::ptu
