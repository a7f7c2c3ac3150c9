#include "programs/chaos/peek.hpp"

#include "blackboard/store/store.hpp"
#include "lisp/reader.hpp"

namespace pizarra::chaos {

std::vector<Datum> facts_of(const memory::MemoryBoard* board, const Datum& pattern) {
  std::vector<Datum> facts;
  if (board == nullptr) return facts;
  const Result<Answers> answers = board->store().ask(query_for(pattern));
  if (!answers) return facts;
  for (const Answer& answer : answers->answers) facts.push_back(answer.facts.front().datum);
  return facts;
}

std::vector<Datum> facts_of(const memory::MemoryBoard* board, std::string_view pattern) {
  return facts_of(board, read_one(pattern).value());
}

std::optional<FactId> fact_id_of(const memory::MemoryBoard* board, const Datum& pattern) {
  if (board == nullptr) return std::nullopt;
  const Result<Answers> answers = board->store().ask(query_for(pattern));
  if (!answers || answers->answers.empty()) return std::nullopt;
  return answers->answers.front().facts.front().id;
}

InHand in_hand(const memory::MemoryBoard* board) {
  static const Datum running = read_one("(operation ? ? running)").value();
  static const Datum servo = read_one("(servo ? ? ? ? ?)").value();
  InHand now;
  const std::vector<Datum> operations = facts_of(board, running);
  if (operations.empty()) return now;
  now.operation = operations.front()[2].head();
  const std::vector<Datum> states = facts_of(board, servo);
  if (!states.empty()) now.servo_state = static_cast<int>(states.front()[1].integer());
  return now;
}

}  // namespace pizarra::chaos
