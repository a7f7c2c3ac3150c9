#include "blackboard/wire/doorkeeper.hpp"

#include <array>
#include <vector>

namespace pizarra::wire {

namespace {

constexpr int questions_at_once = 16;
constexpr std::size_t raw_key_bytes = 32;

// The parts of a question, as RFC 27 orders them.
enum Part : std::size_t { version, request, domain, address, routing_id, mechanism, credentials, parts };

std::string z85(const std::string& raw) {
  std::array<char, raw_key_bytes * 5 / 4 + 1> text{};
  zmq_z85_encode(text.data(), reinterpret_cast<const std::uint8_t*>(raw.data()), raw_key_bytes);
  return text.data();
}

}  // namespace

Doorkeeper::Doorkeeper(Executor& executor, zmq::context_t& context, Admit admit)
    : executor_(executor), admit_(std::move(admit)), socket_(context, zmq::socket_type::rep) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.bind("inproc://zeromq.zap.01");
  file_ = socket_.get(zmq::sockopt::fd);
  executor_.watch_readable(file_, [this] { pump(); });
  schedule_pump();
}

Doorkeeper::~Doorkeeper() {
  executor_.unwatch_readable(file_);
  if (pump_timer_ != 0) executor_.cancel(pump_timer_);
}

void Doorkeeper::pump() {
  for (int i = 0; i < questions_at_once; ++i) {
    if (!answer_one()) return;
  }
  schedule_pump();
}

bool Doorkeeper::answer_one() {
  std::vector<std::string> question;
  try {
    zmq::message_t part;
    if (!socket_.recv(part, zmq::recv_flags::dontwait)) return false;
    question.push_back(part.to_string());
    while (part.more() && socket_.recv(part)) question.push_back(part.to_string());
    const bool whole =
        question.size() == parts && question[mechanism] == "CURVE" && question[credentials].size() == raw_key_bytes;
    const std::string key = whole ? z85(question[credentials]) : std::string();
    const bool welcome = whole && admit_(key);
    question.resize(parts);
    const std::string answer[] = {"1.0",
                                  question[request],
                                  welcome ? "200" : "400",
                                  welcome ? "welcome" : "this key is not authorised",
                                  welcome ? key : "",
                                  ""};
    for (const std::string& text : answer) {
      const bool last = &text == std::end(answer) - 1;
      socket_.send(zmq::buffer(text), last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
  } catch (const zmq::error_t&) {
    // Interrupted by a signal; the executor comes back.
    schedule_pump();
    return false;
  }
  return true;
}

void Doorkeeper::schedule_pump() {
  if (pump_timer_ != 0) return;
  pump_timer_ = executor_.call_at(executor_.now(), [this] {
    pump_timer_ = 0;
    pump();
  });
}

}  // namespace pizarra::wire
