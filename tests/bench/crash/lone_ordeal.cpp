#include "tests/bench/crash/lone_ordeal.hpp"

#include "blackboard/journal/journal_file.hpp"
#include "tests/blackboard/link_proxy.hpp"

namespace pizarra::bench {

namespace {

using namespace std::chrono_literals;

constexpr int links = 4;
// A session is forgotten after 10 s, and what it held and told under its leases long before.
constexpr auto longest_absence = 13s;

std::string link_path(const std::string& folder, int link) { return folder + "/link-" + std::to_string(link); }

}  // namespace

LoneOrdeal::LoneOrdeal(std::string folder, std::uint64_t seed, std::function<bool()> is_stopped)
    : Ordeal(seed, std::move(is_stopped)), folder_(std::move(folder)), links_(start_links(folder_)) {
  start_board();
  for (int number = 0; number < clients; ++number) start_client(number);
  wait_until_begun();
}

Child LoneOrdeal::start_links(const std::string& folder) {
  return Child::running([&](Pipe& parent) {
    std::vector<std::string> paths;
    for (int link = 0; link < links; ++link) paths.push_back(link_path(folder, link));
    LinkProxy(paths, folder + "/board.ipc").run(parent.file());
  });
}

std::string LoneOrdeal::come_to_the_board(int client) { return "ipc://" + link_path(folder_, client % links); }

// A short history, so that the journal is compacted all the time.
void LoneOrdeal::start_board() {
  board_.reset();
  board_.emplace(Child::program({program_beside("pizarra-board"), "--listen", "ipc://" + folder_ + "/board.ipc",
                                 "--journal", folder_ + "/board.journal", "--history", "1000"}));
}

void LoneOrdeal::round() {
  harm(below(7));
  pass(between(200, 600));
}

void LoneOrdeal::harm(std::uint64_t kind) {
  const int number = some_client();
  const auto link = static_cast<int>(below(links));
  const auto change_link = [this, link](LinkProxy::State state) {
    LinkProxy::command(links_.pipe().file(), link, state);
  };
  switch (kind) {
    case 0:
      board_.reset();
      return later(between(0, 300), [this] { start_board(); });
    case 1:
      // Again, perhaps before it has recovered.
      start_board();
      return later(between(1, 40), [this] { start_board(); });
    case 2:
      return start_client(number);
    case 3:
    case 4:
      change_link(kind == 3 ? LinkProxy::State::cut : LinkProxy::State::silent);
      return later(between(50, kind == 3 ? 800 : 4000), [change_link] { change_link(LinkProxy::State::whole); });
    case 5:
      if (Clock::now() < absent_until_) return;
      absent_until_ = Clock::now() + longest_absence;
      return stop_for([this, number] { return client(number); }, between(11'000, 13'000));
    default:
      if (below(2) == 0) return stop_for([this] { return board_ ? &*board_ : nullptr; }, between(50, 1500));
      return stop_for([this, number] { return client(number); }, between(50, 2500));
  }
}

Result<void> LoneOrdeal::read_the_end(store::Store& store) {
  board_.reset();
  const Result<journal::PlayedBack> read = journal::read_journal(folder_ + "/board.journal", store);
  return read ? Result<void>() : fail(read);
}

}  // namespace pizarra::bench
