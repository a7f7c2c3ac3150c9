#include "blackboard/simulated/board_process.hpp"

namespace pizarra::simulated {

namespace {

constexpr const char* journal_path = "/cell.journal";

// As Sessions::random_number() has them.
std::uint64_t session_number(Random& random) { return random.bits() >> 2 | 1; }

}  // namespace

struct BoardProcess::Life {
  Life(Executor& time, Process::Clock clock) : process(time, clock) {}
  Process process;
  std::unique_ptr<wire::Transport> wires;
  std::unique_ptr<server::KeptBoard> kept;
  std::unique_ptr<server::BoardServer> server;
};

BoardProcess::BoardProcess(Executor& time, Network& network, SimulatedDisk& disk, Random random, std::string address)
    : time_(time), network_(network), disk_(disk), random_(random), address_(std::move(address)) {}

BoardProcess::~BoardProcess() {
  if (lives()) kill();
}

Result<void> BoardProcess::start(Process::Clock clock) {
  const auto wall_clock = [&] { return time_.now() + clock.ahead; };
  const Time first = server::first_moment(wall_clock, journal_path, disk_);
  clock.ahead = first - time_.now();
  auto life = std::make_unique<Life>(time_, clock);
  disk_.on_wait = [process = &life->process](Duration took) { process->spend(took); };
  ++lives_;
  const Result<void> begun = begin(*life);
  life_ = std::move(life);
  if (!begun) kill();
  return begun;
}

Result<void> BoardProcess::begin(Life& life) {
  const Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open(journal_path, {}, disk_);
  if (!file) return fail(file);
  life.wires = network_.plug(name, life.process);
  life.kept = std::make_unique<server::KeptBoard>(life.process);
  const Result<void> begun = life.kept->begin(*file);
  if (!begun) return begun;
  server::BoardServerOptions options;
  options.addresses = {address_};
  options.journal = life.kept->journal();
  options.remembered = life.kept->take_remembered();
  options.transport = life.wires.get();
  options.random_number = [this] { return session_number(random_); };
  Result<std::unique_ptr<server::BoardServer>> server =
      server::BoardServer::open(life.process, life.kept->board(), options);
  if (!server) return fail(server);
  life.server = std::move(*server);
  return {};
}

// Its parts are destroyed once none of them reaches the network or the disk any more.
void BoardProcess::kill() {
  life_->process.kill();
  network_.unplug(name);
  disk_.detach();
  disk_.on_wait = nullptr;
  life_.reset();
}

void BoardProcess::cut_power() {
  kill();
  disk_.cut_power();
}

Process* BoardProcess::process() const { return lives() ? &life_->process : nullptr; }

memory::MemoryBoard* BoardProcess::board() { return lives() ? &life_->kept->board() : nullptr; }

}  // namespace pizarra::simulated
