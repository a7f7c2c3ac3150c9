#include "programs/chaos/chaos_cell.hpp"

#include <algorithm>

#include "programs/chaos/peek.hpp"
#include "programs/chaos/planted_board.hpp"

namespace pizarra::chaos {

namespace {

constexpr simulated::Network::Delay usual_delay{.least = 50us, .most = 400us};
// Wall clocks do not begin at 0.
constexpr Duration epoch = std::chrono::hours(24) * 20'000;
// Of every second arm's controller. The others move on to the end of their motion.
constexpr Duration silence_limit = 100ms;

}  // namespace

struct ChaosCell::Agent {
  Agent(ChaosCell& cell, const std::string& kind)
      : process(cell.time_, cell.new_clock()), line(kind, process, *cell.world_) {}
  simulated::Process process;
  DeviceLine line;
  std::unique_ptr<wire::Transport> wires;
  std::unique_ptr<client::RemoteBoard> board;
  std::unique_ptr<Board> mistaken;
  std::unique_ptr<Board> planted;
  std::unique_ptr<launcher::BuiltAgent> agent;
  Job job;
};

ChaosCell::ChaosCell(Executor& time, forms::CellDescription description, std::uint64_t seed, Clocks clocks,
                     std::string plant)
    : time_(time),
      description_(std::move(description)),
      random_(seed),
      clock_draws_(random_.split("clocks")),
      clocks_(clocks),
      plant_(std::move(plant)),
      network_(time, random_.split("network"), usual_delay),
      disk_(random_.split("disk")),
      world_(std::make_unique<WorldProcess>(time, simulated::Process::Clock{.ahead = epoch}, plant_)),
      board_(time, network_, disk_, random_.split("board"), address) {
  world_->world =
      std::make_unique<simulation::World>(world_->process, launcher::world_config(description_, seed).value());
  world_->servo_state = [this] { return in_hand(board_.board()).servo_state; };
  if (random_.split("controller").below(2) == 0) world_->silence_limit = silence_limit;
  disk_.lie(plant_ == "disk-lies");
  network_.let_frames_overtake(plant_ == "frames-overtake");
}

ChaosCell::~ChaosCell() {
  time_.cancel(supervision_);
  for (const std::string& kind : kinds()) take_down(kind);
}

simulated::Process::Clock ChaosCell::new_clock() {
  const double apart = static_cast<double>(clocks_.apart.count());
  const double drawn = clock_draws_.uniform(-1, 1);
  return {.ahead = epoch + Duration(static_cast<Duration::rep>(apart * drawn)),
          .drift = clocks_.drift * clock_draws_.uniform(-1, 1)};
}

Result<void> ChaosCell::start_all() {
  start_board();
  for (const std::string& kind : kinds()) {
    const Result<void> started = start(kind);
    if (!started) return started;
  }
  supervise();
  return {};
}

Result<void> ChaosCell::start(const std::string& kind) {
  auto agent = std::make_unique<Agent>(*this, kind);
  agent->wires = network_.plug(kind, agent->process);
  Result<std::unique_ptr<client::RemoteBoard>> board = client::RemoteBoard::connect(
      agent->process, address, kind, client::RemoteBoard::default_timeout, {}, *agent->wires);
  if (!board) return fail(board);
  agent->board = std::move(*board);
  const std::string life = kind + std::to_string(++lives_[kind]);
  Board* seen = agent->board.get();
  if (kind == "vision") {
    agent->mistaken = std::make_unique<MistakenEyes>(*seen, time_, mistakes_);
    seen = agent->mistaken.get();
  }
  if (!plant_.empty()) {
    agent->planted = std::make_unique<PlantedBoard>(*seen, agent->process, kind, plant_);
    seen = agent->planted.get();
  }
  runtime::AgentContext context{kind, "localhost", agent->process, *seen, random_.split(life)};
  Result<std::unique_ptr<launcher::BuiltAgent>> built =
      launcher::build_agent(kind, std::move(context), description_, agent->line, &streams_);
  if (!built) return fail(built);
  agent->agent = std::move(*built);
  agent->job = agent->process.spawn(agent->agent->run());
  agents_[kind] = std::move(agent);
  return {};
}

// Nothing of it is heard any more before it is taken down.
void ChaosCell::take_down(const std::string& kind) {
  const auto found = agents_.find(kind);
  if (found == agents_.end()) return;
  const std::unique_ptr<Agent> agent = std::move(found->second);
  agents_.erase(found);
  agent->process.kill();
  network_.unplug(kind);
  agent->job = Job();
}

void ChaosCell::kill(const std::string& kind, Duration away, std::uint64_t after_steps) {
  simulated::Process* process = process_of(kind);
  if (process == nullptr || kind == simulated::BoardProcess::name) return;
  away_until_[kind] = time_.now() + away;
  process->kill_at(process->steps() + after_steps, [this, kind, away] {
    away_until_[kind] = time_.now() + away;
    take_down(kind);
  });
}

void ChaosCell::kill_board(Duration away, bool power, std::uint64_t after_steps) {
  if (!board_.lives()) return;
  simulated::Process& process = *board_.process();
  process.kill_at(process.steps() + after_steps, [this, away, power] {
    board_away_until_ = time_.now() + away;
    if (power) {
      board_.cut_power();
    } else {
      board_.kill();
    }
  });
}

void ChaosCell::pause(const std::string& kind, Duration length, std::uint64_t after_steps) {
  simulated::Process* process = process_of(kind);
  if (process == nullptr) return;
  process->hold_at(process->steps() + after_steps, [this, kind, process, length] {
    process->pause();
    resume_after(length, kind);
  });
}

void ChaosCell::jump_clock(const std::string& kind, Duration ahead) {
  simulated::Process* process = process_of(kind);
  if (process == nullptr || process->paused()) return;
  if (ahead >= Duration::zero()) return process->jump(ahead);
  process->suspend();
  resume_after(-ahead, kind);
}

void ChaosCell::resume_after(Duration length, const std::string& kind) {
  time_.call_at(time_.now() + length, [this, kind, process = process_of(kind)] {
    // It may be another by now.
    if (process_of(kind) == process) process->resume();
  });
}

void ChaosCell::exchange_names(std::string one, std::string other, Duration length) {
  mistakes_.names = {.until = time_.now() + length, .one = std::move(one), .other = std::move(other)};
}

void ChaosCell::invent_sighting(InventedSighting invented) { mistakes_.invented = std::move(invented); }

void ChaosCell::heal() {
  mistakes_ = {};
  network_.set_delay(usual_delay);
  disk_.fail(false);
  disk_.set_capacity(simulated::SimulatedDisk::plenty);
  disk_.set_flush_time({});
  // An alarm stays until somebody resets it.
  const bool alarm = world_->faults.alarm;
  world_->faults = {};
  world_->faults.alarm = alarm;
  for (auto& [kind, until] : away_until_) until = {};
  board_away_until_ = {};
  for (auto& [kind, agent] : agents_) let_live(agent->process);
  if (board_.lives()) let_live(*board_.process());
}

void ChaosCell::let_live(simulated::Process& process) {
  constexpr std::uint64_t never = ~std::uint64_t{0};
  if (process.alive()) process.kill_at(never, {});
  process.hold_at(never, {});
  if (process.paused()) process.resume();
}

void ChaosCell::start_board() {
  if (board_.lives()) return;
  if (plant_ == "journal-gone") disk_.erase();
  const Result<void> begun = board_.start(new_clock());
  if (!begun) board_away_until_ = time_.now() + 1s;
}

void ChaosCell::supervise() {
  supervision_ = time_.call_at(time_.now() + supervision, [this] { supervise(); });
  const Time now = time_.now();
  if (board_away_until_ <= now) start_board();
  for (const std::string& kind : kinds()) {
    const auto found = agents_.find(kind);
    const bool ended = found != agents_.end() && found->second->agent->ended() != nullptr;
    if (ended) {
      take_down(kind);
      away_until_[kind] = now + 1s;
    }
    if (agents_.contains(kind) || away_until_[kind] > now) continue;
    if (plant_ == "not-restarted" && kind == "planner") continue;
    // The cause that keeps it from starting now may be gone at the next attempt.
    if (!start(kind)) away_until_[kind] = now + 1s;
  }
}

simulated::Process* ChaosCell::process_of(const std::string& kind) {
  if (kind == simulated::BoardProcess::name) return board_.process();
  const auto found = agents_.find(kind);
  return found == agents_.end() ? nullptr : &found->second->process;
}

int ChaosCell::lives(const std::string& kind) const {
  const auto found = lives_.find(kind);
  return found == lives_.end() ? 0 : found->second;
}

bool ChaosCell::runs(const std::string& kind) const {
  if (kind == simulated::BoardProcess::name) return board_.lives() && !board_.process()->paused();
  const auto found = agents_.find(kind);
  return found != agents_.end() && found->second->process.alive() && !found->second->process.paused();
}

ChaosCell::Client::Client(ChaosCell& cell, const std::string& the_name)
    : process(cell.time(), {.ahead = epoch}),
      wires(cell.network().plug(the_name, process)),
      board(client::RemoteBoard::connect(process, address, the_name, client::RemoteBoard::default_timeout, {}, *wires)
                .value()),
      network(cell.network()),
      name(the_name) {}

ChaosCell::Client::~Client() { network.unplug(name); }

}  // namespace pizarra::chaos
