// Each line of the input is a frame that a server says to a RemoteBoard, REQUEST standing for the number of a question
// under way and WATCH for that of a watch; then the question must still come to an end.

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <unistd.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/wire/wire_socket.hpp"
#include "lisp/writer.hpp"
#include "tests/fuzz/frames.hpp"
#include "tests/scratch.hpp"

using namespace pizarra;

namespace {

Query anything() { return query_from_datum(read_one("(and (on ?x ?y) (not (clear ?x)))").value()).value(); }

class ClientUnderTest {
 public:
  ClientUnderTest() {
    const std::string address = "ipc://" + scratch_folder() + "client";
    if (!server_.bind(address)) std::abort();
    board_ = client::RemoteBoard::connect(executor_, address, "fuzz").value();
    watching_ = executor_.spawn(watch());
  }

  void hear(std::string_view text) {
    question_.clear();
    const Job asking = executor_.spawn(ask());
    run_until([&] { return !question_.empty(); });
    for (const std::string& frame : frames_of(text, "REQUEST", question_)) {
      for (const std::string& once_more : frames_of(frame, "WATCH", watch_)) server_.send(client_, once_more);
    }
    server_.send(client_, "(reply " + question_ + " (ok (1)))");
    run_until([&] { return asking.done(); });
  }

 private:
  template <class Condition>
  void run_until(const Condition& condition) {
    bool late = false;
    const auto timer = executor_.call_at(executor_.now() + 10s, [&] { late = true; });
    executor_.run_until([&] { return late || condition(); });
    executor_.cancel(timer);
    if (late) std::abort();
  }

  Task<void> ask() {
    Query query = anything();
    [[maybe_unused]] const Result<Answers> answers = co_await board_->ask(std::move(query));
  }
  Task<void> watch() {
    while (true) {
      Query query = anything();
      const Result<std::unique_ptr<Watch>> watch = co_await board_->watch(std::move(query));
      bool goes_on = watch.has_value();
      while (goes_on) {
        const Result<Change> change = co_await (*watch)->next();
        goes_on = change.has_value();
      }
      co_await sleep(executor_, 1ms);
    }
  }
  // A server that welcomes, lets watch, and leaves questions open.
  void receive(const std::string& client, std::string_view frame) {
    client_ = client;
    const std::vector<Datum> messages = wire::read_messages(frame).value();
    for (const Datum& message : messages) answer(client, message);
  }
  void answer(const std::string& client, const Datum& message) {
    if (message.is_form("hello")) server_.send(client, "(welcome 7 1)");
    if (message.is_form("ping")) server_.send(client, "(pong)");
    if (!message.is_form("request")) return;
    if (message[3].is_form("ask")) question_ = write(message[2]);
    if (!message[3].is_form("watch")) return;
    watch_ = write(message[3][1]);
    server_.send(client, write(list("reply"_sym, message[2], list("ok"_sym, list()))));
  }

  RealExecutor executor_;
  wire::WireSocket server_{
      executor_, wire::WireSocket::Kind::router,
      [this](const std::string& peer, std::optional<std::string_view> frame) { receive(peer, frame.value()); }};
  std::string client_;
  std::string question_;
  std::string watch_ = "0";
  std::unique_ptr<client::RemoteBoard> board_;
  Job watching_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static ClientUnderTest tested;
  tested.hear({reinterpret_cast<const char*>(data), size});
  return 0;
}
