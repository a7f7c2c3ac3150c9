// A domain whose rules ask for more than one look may take.

#include <fstream>
#include <gtest/gtest.h>

#include "agents/coordinator/pursue/coordinator_agent.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::coordinator {
namespace {

Datum datum_of(std::string_view text) { return read_one(text).value(); }

// The blocks with a last rule that joins everything seen with everything seen, eight times.
std::string wide_domain() {
  std::string text = whole_file(source_dir() + "/domains/blocks.scm");
  std::string rule = "(rule (wide)";
  for (int i = 0; i < 8; ++i) rule += " (seen ?q" + std::to_string(i) + " ? ? ?)";
  rule += " (< 1 0))\n";
  text.insert(text.find("(rule (holding"), rule);
  const std::string file = scratch_folder() + "too-wide.scm";
  std::ofstream(file) << text;
  return file;
}

class TooMuchWork : public testing::Test {
 protected:
  TooMuchWork() {
    EXPECT_TRUE(board_.declare(
        "vision", {relation_from_datum(
                       datum_of("(relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))"))
                       .value(),
                   relation_from_datum(
                       datum_of("(relation camera-model ((eyes symbol) (w integer) (h integer) (f number) (x number) "
                                "(y number) (b number)) (key eyes))"))
                       .value()}));
    tell("(camera-model vision 320 240 431.0 159.5 119.5 90.0)");
  }

  void tell(std::string_view fact) {
    Transaction transaction;
    transaction.tell(datum_of(fact));
    EXPECT_TRUE(board_.transact("vision", transaction)) << fact;
  }
  // One look that sees as many marks.
  void look(int frame, int marks) {
    std::string text = "(TRACK " + std::to_string(marks);
    for (int i = 0; i < marks; ++i) {
      text += " (\"m" + std::to_string(i) + "\" OK (" + std::to_string(10 + 20 * i) + ", 150, 1000))";
    }
    Transaction says;
    says.tell(list("look"_sym, "vision"_sym, frame, to_datum(text + ")"), Datum()));
    EXPECT_TRUE(board_.transact("vision", says));
    executor_.run_for(100ms);
  }
  std::vector<Datum> facts(std::string_view pattern) {
    std::vector<Datum> found;
    const Answers answers = board_.ask(query_from_datum(datum_of(pattern)).value()).value();
    for (const Answer& answer : answers.answers) {
      found.push_back(answer.facts.front().datum);
    }
    return found;
  }

  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
};

Task<void> live(CoordinatorAgent& agent) { co_await agent.run(); }

TEST_F(TooMuchWork, IsToldOnceAndLeavesWhatWasBelieved) {
  CoordinatorOptions options;
  options.domain_file = wide_domain();
  const std::unique_ptr<Board> view = board_.view("coordinator");
  CoordinatorAgent agent({"coordinator", "localhost", executor_, *view, Random(1)}, options);
  const Job job = executor_.spawn(live(agent));
  executor_.run_for(1s);
  for (int frame = 1; frame <= 5; ++frame) look(frame, 2);
  const std::vector<Datum> believed = facts("(believed ?fact)");
  EXPECT_FALSE(believed.empty());
  for (int frame = 6; frame <= 20; ++frame) look(frame, 10);
  std::vector<Datum> told;
  for (const Datum& event : facts("(event ?n ?kind ?sentence ?detail)")) {
    if (event[4].is_form("fail") && event[4][1].is_symbol("too-much-work")) told.push_back(event);
  }
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0][3].text().find("the rule for wide"), std::string_view::npos) << told[0][3].text();
  EXPECT_EQ(facts("(believed ?fact)"), believed);
  for (int frame = 21; frame <= 40; ++frame) look(frame, 1);
  EXPECT_NE(facts("(believed ?fact)"), believed) << "what can be perceived again is believed again";
}

}  // namespace
}  // namespace pizarra::coordinator
