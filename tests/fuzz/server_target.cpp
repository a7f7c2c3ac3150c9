// Each line of the input is a frame that one client says to a board server, SESSION standing for its session; then the
// server must still answer it.

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>

#include "blackboard/server/board_server.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/scratch.hpp"

using namespace pizarra;

namespace {

class ServerUnderTest {
 public:
  ServerUnderTest() {
    if (!client_.connect(server_->addresses().front())) std::abort();
    expect("(hello \"fuzz\" 0)");
    if (heard_ != "welcome") std::abort();
  }

  // False where what was said ended the session.
  bool hear(std::string_view text) {
    for (const std::string& frame : frames_of(text, "SESSION", session_)) client_.send({}, frame);
    expect("(ping " + session_ + ")");
    return heard_ == "pong";
  }

 private:
  // Says it until a pong, a welcome or an unknown session is heard.
  void expect(const std::string& frame) {
    heard_.clear();
    const Time patience = executor_.now() + 10s;
    Time say_at{};
    while (heard_.empty()) {
      if (executor_.now() > patience) std::abort();
      if (executor_.now() >= say_at && client_.send({}, frame)) say_at = executor_.now() + 500ms;
      bool waited = false;
      const auto timer = executor_.call_at(executor_.now() + 5ms, [&] { waited = true; });
      executor_.run_until([&] { return waited || !heard_.empty(); });
      executor_.cancel(timer);
    }
  }
  void receive(std::string_view frame) {
    const Result<std::vector<Datum>> messages = wire::read_messages(frame);
    if (!messages) std::abort();
    for (const Datum& message : *messages) {
      const std::string_view kind = message.head();
      if (kind == "welcome") session_ = std::to_string(message[1].integer());
      if (kind == "welcome" || kind == "pong" || kind == "unknown-session") heard_ = kind;
    }
  }

  RealExecutor executor_;
  MemoryBoard board_{executor_};
  std::unique_ptr<BoardServer> server_ =
      BoardServer::open(executor_, board_, {.addresses = {"ipc://" + scratch_folder() + "server"}}).value();
  WireSocket client_{executor_, WireSocket::Kind::dealer,
                     [this](const std::string&, std::optional<std::string_view> frame) { receive(frame.value()); }};
  std::string session_ = "0";
  std::string heard_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int inputs_of_a_board = 500;
  static int inputs = 0;
  static std::unique_ptr<ServerUnderTest> tested;
  // The former one gives its address back first.
  if (inputs++ % inputs_of_a_board == 0) tested.reset();
  if (tested == nullptr) tested = std::make_unique<ServerUnderTest>();
  if (!tested->hear({reinterpret_cast<const char*>(data), size})) tested.reset();
  return 0;
}
