// Two clients talk to a board server that keeps a journal: each line of the input is a frame. A line that begins with
// `!` is of the client that comes over the network with a key that permits little; the others are of the client of this
// machine. SESSION stands for the session of the first, KEYED for that of the second. Then the server must still answer
// who said something, and the next board must find in the journal what this one had to keep.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unistd.h>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/fuzz/fuzzed_client.hpp"
#include "tests/scratch.hpp"

using namespace pizarra;

namespace {

// In memory, and gone when the process ends.
struct Journal {
  ~Journal() { journal::remove_journal(path); }

  const std::string path = "/dev/shm/pizarra-fuzz-server-" + std::to_string(getpid());
};
const Journal kept_journal;

// The board's and the second client's.
const std::string& key_folder() {
  static const std::string folder = [] {
    std::string made = scratch_folder() + "keys";
    const wire::Permissions little{{"note", "own-*"}, {"note"}, {"note", "goal"}, {}};
    if (!wire::make_keys(made, "board", {}) || !wire::make_keys(made, "robot", little)) std::abort();
    return made;
  }();
  return folder;
}

// The ids of what the next board must have, for it goes with no lease.
std::set<FactId> kept_by(const store::Store& store) {
  std::set<FactId> kept;
  for (const auto& [name, table] : store.tables()) {
    if (!table.relation().durable) continue;
    std::vector<Datum> pattern(table.relation().arguments.size() + 1, "?"_sym);
    pattern[0] = Datum::symbol(name);
    table.visit(Datum::list(pattern), [&](const Fact& fact) {
      if (store.lease_of(fact.id) == 0) kept.insert(fact.id);
      return true;
    });
  }
  return kept;
}

// Must succeed.
template <class Value>
Value sound(Result<Value> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s: %s\n", result.error().symbol.c_str(), result.error().sentence.c_str());
  std::abort();
}

class ServerUnderTest {
 public:
  // Goes on from what the one before it left in the journal.
  explicit ServerUnderTest(const std::set<FactId>& kept) {
    board_.set_journal([this](std::string_view line) { writer_.append(line); });
    board_.resume();
    if (!std::ranges::includes(kept_by(board_.store()), kept)) std::abort();
    server::BoardServerOptions options;
    options.addresses = {"ipc://" + scratch_folder() + "server", "tcp://127.0.0.1:*"};
    options.keys = key_folder();
    options.journal = &writer_;
    options.remembered = remembered_;
    server_ = sound(server::BoardServer::open(executor_, board_, options));
    near_ = std::make_unique<FuzzedClient>(executor_, "fuzz", server_->addresses()[0]);
    keyed_ = std::make_unique<FuzzedClient>(executor_, "robot", server_->addresses()[1], &keys_);
  }

  void hear(std::string_view text) {
    bool by_near = false;
    bool by_keyed = false;
    for (const std::string& line : frames_of(text, "SESSION", near_->session())) {
      for (const std::string& frame : frames_of(line, "KEYED", keyed_->session())) {
        const bool by_second = frame.starts_with('!');
        (by_second ? by_keyed : by_near) = true;
        (by_second ? keyed_ : near_)->say(by_second ? frame.substr(1) : frame);
      }
    }
    if (by_near) near_->go_on();
    if (by_keyed) keyed_->go_on();
  }
  std::set<FactId> kept() const { return kept_by(board_.store()); }

 private:
  std::unique_ptr<store::Store> recovered() {
    auto store = std::make_unique<store::Store>();
    remembered_ = sound(file_->recover(*store));
    return store;
  }

  RealExecutor executor_;
  const wire::ClientKeys keys_ = sound(wire::read_client_keys(key_folder() + "/robot.secret"));
  const std::shared_ptr<journal::JournalFile> file_ = sound(journal::JournalFile::open(kept_journal.path, {}));
  std::vector<journal::RememberedReply> remembered_;
  memory::MemoryBoard board_{executor_, recovered()};
  journal::JournalWriter writer_{executor_, file_};
  std::unique_ptr<server::BoardServer> server_;
  std::unique_ptr<FuzzedClient> near_;
  std::unique_ptr<FuzzedClient> keyed_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int inputs_of_a_board = 500;
  constexpr int inputs_of_a_journal = 10 * inputs_of_a_board;
  static int inputs = 0;
  static std::unique_ptr<ServerUnderTest> tested;
  if (inputs % inputs_of_a_board == 0) {
    const bool anew = inputs % inputs_of_a_journal == 0;
    const std::set<FactId> kept = tested == nullptr || anew ? std::set<FactId>() : tested->kept();
    // The former one gives its address back first.
    tested.reset();
    if (anew) journal::remove_journal(kept_journal.path);
    tested = std::make_unique<ServerUnderTest>(kept);
  }
  ++inputs;
  tested->hear({reinterpret_cast<const char*>(data), size});
  return 0;
}
