#include "drivers/simulation/controllers/ptu_emulator.hpp"

#include <utility>

namespace pizarra::simulation {

namespace {

constexpr std::string_view delimiters = " \r\n";

}  // namespace

PtuEmulator::PtuEmulator(Executor& executor, const PtuModel& model)
    : executor_(executor), unit_(model), come_(executor), advanced_to_(executor.now()) {
  working_ = executor_.spawn(work(false));
}

void PtuEmulator::receive(std::string_view bytes) {
  if (!powered_) return;
  const bool full = waiting_.size() + bytes.size() > most_waiting;
  // No command is that long: without this, none would ever come to its end again.
  if (full && waiting_.find_first_of(delimiters) == std::string::npos) waiting_.clear();
  waiting_.append(bytes.substr(0, most_waiting - waiting_.size()));
  come_.wake_all();
}

void PtuEmulator::power(bool on) {
  if (on == powered_) return;
  advance();
  powered_ = on;
  working_ = Job();
  watching_pan_ = Job();
  watching_tilt_ = Job();
  waiting_.clear();
  if (!on) {
    unit_.pan.axis.lose_power();
    unit_.tilt.axis.lose_power();
    return;
  }
  unit_.restore();
  unit_.pure_velocity = false;
  working_ = executor_.spawn(work(true));
}

double PtuEmulator::pan_deg() {
  advance();
  return unit_.pan.axis.angle_deg();
}

double PtuEmulator::tilt_deg() {
  advance();
  return unit_.tilt.axis.angle_deg();
}

bool PtuEmulator::moving() {
  advance();
  return unit_.moving();
}

void PtuEmulator::advance() {
  const Time now = executor_.now();
  if (powered_) unit_.advance(now - advanced_to_);
  advanced_to_ = now;
}

void PtuEmulator::say(std::string_view text) {
  if (say_) say_(text);
}

// The next command whose delimiter has come; empty while there is none.
std::string PtuEmulator::next_command() {
  while (true) {
    const std::size_t end = waiting_.find_first_of(delimiters);
    if (end == std::string::npos) return "";
    std::string command = waiting_.substr(0, end);
    waiting_.erase(0, end + 1);
    if (!command.empty()) return command;
  }
}

Task<void> PtuEmulator::work(bool power_up) {
  if (power_up) {
    co_await reset(unit_.modes.pan_reset_at_power_up, unit_.modes.tilt_reset_at_power_up);
    say("*\r\n");
  }
  while (true) {
    std::string command = next_command();
    if (command.empty()) {
      co_await come_.wait();
      continue;
    }
    co_await obey_one(std::move(command));
  }
}

Task<void> PtuEmulator::obey_one(std::string command) {
  advance();
  const std::string echoed = unit_.modes.echo ? command + " " : "";
  const PtuAnswer answer = obey(unit_, command);
  say(echoed);
  if (unit_.pan.axis.hits_stop() && unit_.pan.axis.moving()) watching_pan_ = executor_.spawn(watch_stop(unit_.pan));
  if (unit_.tilt.axis.hits_stop() && unit_.tilt.axis.moving()) watching_tilt_ = executor_.spawn(watch_stop(unit_.tilt));
  if (answer.wait) co_await until_still();
  co_await reset(answer.reset_pan, answer.reset_tilt);
  say(answer.text + "\r\n");
}

Task<void> PtuEmulator::reset(bool pan, bool tilt) {
  if (tilt) co_await calibrate(unit_.tilt);
  if (pan) co_await calibrate(unit_.pan);
}

// To one stop and the other, and from there to the middle, however slow it was told to be.
Task<void> PtuEmulator::calibrate(PtuChannel& channel) {
  const PtuSpeeds told = std::exchange(channel.axis.speeds(), unit_.model->speeds);
  co_await hit_stop(channel, false);
  co_await hit_stop(channel, true);
  channel.axis.calibrate();
  channel.axis.go_to(0);
  channel.awaited = 0;
  co_await until_still(channel.axis);
  channel.axis.speeds() = told;
}

Task<void> PtuEmulator::hit_stop(PtuChannel& channel, bool high) {
  advance();
  channel.axis.go_to_stop(high);
  co_await until_still(channel.axis);
  say_hit(channel);
}

// Says so when an axis that was sent beyond its stop, its limits being off, has arrived there.
Task<void> PtuEmulator::watch_stop(PtuChannel& channel) {
  while (channel.axis.hits_stop() && channel.axis.moving()) {
    co_await sleep(executor_, look_again);
    advance();
  }
  if (channel.axis.hits_stop()) say_hit(channel);
}

void PtuEmulator::say_hit(const PtuChannel& channel) {
  const char hit[] = {'!', channel.letter};
  say({hit, sizeof hit});
}

Task<void> PtuEmulator::until_still(const PtuAxis& axis) {
  advance();
  while (axis.moving()) {
    co_await sleep(executor_, look_again);
    advance();
  }
}

Task<void> PtuEmulator::until_still() {
  advance();
  while (unit_.moving()) {
    co_await sleep(executor_, look_again);
    advance();
  }
}

}  // namespace pizarra::simulation
