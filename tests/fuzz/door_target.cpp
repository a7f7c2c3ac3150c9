// A device at the text door says the input, and goes. The door must answer with lines that are whole, short and known,
// let nobody tell or see what his pass does not permit, and still serve the next device. A pass stands for the name
// `barrier`, with the token `t`.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <sys/socket.h>
#include <unistd.h>

#include "agents/door/guest.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"

using namespace pizarra;

namespace {

constexpr std::string_view secret = "zyxwvutsrqponmlkjihgfedcba";

[[noreturn]] void give_up(std::string_view why, std::string_view about) {
  std::fprintf(stderr, "%.*s: %.*s\n", static_cast<int>(why.size()), why.data(), static_cast<int>(about.size()),
               about.data());
  std::abort();
}

// Told under the name of somebody else; a device that could, would change it.
Datum secret_fact() { return list("secret"_sym, Datum::symbol(std::string(secret))); }

class DoorUnderTest {
 public:
  DoorUnderTest() {
    for (const char* form : {"(relation blocked ((barrier symbol)))", "(relation secret ((what symbol)))",
                             "(relation turned ((table symbol) (degrees number)) (key table))"}) {
      if (!board_.declare("owner", {*relation_from_datum(*read_one(form))})) give_up("not declared", form);
    }
    const Job telling = executor_.spawn(tell_secret());
    executor_.run_until([&telling] { return telling.done(); });
  }

  // The door's answers to a device that said this.
  std::string answers_to(std::string_view said) {
    std::array<int, 2> files{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, files.data()) != 0) std::abort();
    std::string heard;
    {
      door::Lines lines(executor_, files[0]);
      const auto admit = [this](const std::string& name, const std::string& token) -> Result<door::Guest::Admitted> {
        if (name != "barrier" || token != "t") return fail("not-permitted", "name or token is wrong");
        const wire::Permissions may{{"blocked", "own-*"}, {"own-*"}, {"blocked", "turned", "own-*"}, {}};
        return door::Guest::Admitted{{name, may, {}}, board_.view(name)};
      };
      door::Guest guest(executor_, lines, admit);
      const Job job = executor_.spawn(serve(guest, lines));
      executor_.run_until([&] {
        const ssize_t sent = said.empty() ? 0 : ::send(files[1], said.data(), said.size(), MSG_NOSIGNAL);
        if (sent > 0) said.remove_prefix(static_cast<std::size_t>(sent));
        if (said.empty() || (sent < 0 && errno != EAGAIN)) ::shutdown(files[1], SHUT_WR);
        receive(files[1], heard);
        return job.done();
      });
    }
    receive(files[1], heard);
    ::close(files[1]);
    return heard;
  }

  void check_secret() const {
    std::size_t count = 0;
    board_.store().tables().at("secret").visit(secret_fact(), [&count](const Fact&) {
      ++count;
      return true;
    });
    if (count != 1) give_up("a device changed what it may not tell", "secret");
  }

 private:
  Task<void> tell_secret() {
    const Datum fact = secret_fact();
    const Result<Revision> told = co_await owner_->tell(fact);
    if (!told) give_up("not told", told.error().sentence);
  }

  static Task<void> serve(door::Guest& guest, door::Lines& lines) {
    co_await guest.run(std::nullopt);
    co_await lines.finish();
  }

  static void receive(int file, std::string& heard) {
    std::array<char, 16384> chunk{};
    for (ssize_t count = 0; (count = ::recv(file, chunk.data(), chunk.size(), MSG_DONTWAIT)) > 0;) {
      heard.append(chunk.data(), static_cast<std::size_t>(count));
    }
  }

  RealExecutor executor_;
  memory::MemoryBoard board_{executor_};
  std::unique_ptr<Board> owner_ = board_.view("owner");
};

void check_answers(std::string_view heard) {
  if (heard.find(secret) != std::string_view::npos) give_up("a device saw what it may not read", heard);
  while (!heard.empty()) {
    const std::size_t end = heard.find('\n');
    if (end == std::string_view::npos) give_up("half a line", heard);
    const std::string line(heard.substr(0, end));
    heard.remove_prefix(end + 1);
    if (line.size() > door::Lines::longest) give_up("an answer that is too long", line);
    const Result<Datum> form = read_one(line);
    const auto is = [&form](const char* head) { return form->is_form(head); };
    constexpr std::array heads{"welcome", "ok", "fail", "closed", "anew", "went", "came", "now", "lost"};
    if (!form || std::ranges::none_of(heads, is)) give_up("an answer that is none", line);
    if (is("closed") && !heard.empty()) give_up("an answer behind the end", heard);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int inputs_of_a_board = 500;
  static int inputs = 0;
  static std::unique_ptr<DoorUnderTest> tested;
  const std::string_view said(reinterpret_cast<const char*>(data), size);
  // The fuzzer learns the secret from the comparison with it. An answer that repeats what was said shows no leak.
  if (said.find(secret) != std::string_view::npos) return 0;
  if (inputs++ % inputs_of_a_board == 0) tested = std::make_unique<DoorUnderTest>();
  check_answers(tested->answers_to(said));
  tested->check_secret();
  const std::string next = tested->answers_to("(hello barrier \"t\")\n(ask (blocked somebody))\n");
  if (!next.starts_with("(welcome barrier)\n(ok")) give_up("the next device is not served", next);
  return 0;
}
