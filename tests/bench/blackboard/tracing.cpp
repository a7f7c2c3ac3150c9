// What it costs to time a fact's journey: tells that say when they were sent, every one of them, against tells that do
// not. A client says so of a hundred a second at most.

#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/raw_zmq.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int trips = 3000;  // in a round

// A session that says what it is told to.
class Speaker {
 public:
  explicit Speaker(const std::string& address) : dealer_(address) {
    dealer_.send("(hello \"speaker\" 0)");
    session_ = read_one(dealer_.receive()).value()[1].integer();
    request("(declare " + write(relation_to_datum(object_relation())) + ")", false);
  }
  double tells_us(bool timed) {
    std::vector<double> took_us;
    for (int i = 0; i < trips; ++i) {
      const std::string body = "(transact () ((tell " + write(object_fact(i % 100, request_)) + " 0)))";
      const double begun = now_us();
      request(body, timed);
      took_us.push_back(now_us() - begun);
    }
    return percentile(took_us, 0.5);
  }

 private:
  void request(const std::string& body, bool timed) {
    dealer_.send(fmt::format("(request {} {} {}{})", session_, ++request_, body, timed ? " 1000000" : ""));
    const Datum reply = read_one(dealer_.receive()).value();
    if (!reply[2].is_form("ok")) throw std::runtime_error("the board says " + write(reply));
  }

  RawDealer dealer_;
  std::int64_t session_ = 0;
  int request_ = 0;
};

}  // namespace

void tracing(Figures& figures) {
  const BoardProcess server;
  Speaker speaker(server.address());
  const std::vector<double> us =
      medians_of_rounds(rounds, {[&] { return speaker.tells_us(true); }, [&] { return speaker.tells_us(false); }});
  figures.say({"tell, acknowledged, its journey timed, p50", us[0], "us", {}, {{"untimed", us[1]}}});
}

}  // namespace pizarra::bench
