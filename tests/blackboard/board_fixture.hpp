#pragma once

// What every behaviour test of the walls begins with: two tellers and a few relations.

#include "tests/blackboard/wall.hpp"

namespace pizarra {

class BoardTest : public testing::TestWithParam<WallKind> {
 protected:
  BoardTest() : wall(GetParam().make()), alice(wall->view("alice")), bob(wall->view("bob")) {
    const Result<void> declared = wall->run(alice->declare(relations()));
    EXPECT_TRUE(declared.has_value());
  }

  static std::vector<Relation> relations() {
    return {relation("(relation seen ((name string) (x number) (y number)) (key name))"),
            relation("(relation on ((upper symbol) (lower symbol)))"),
            relation("(relation mode ((name symbol)) (key))"),
            relation("(relation note ((n integer) (text datum)) (key n))"),
            relation("(relation alarm ((text string)) (lease 2000))")};
  }

  Result<Revision> tell(Board& board, const std::string& fact) { return wall->run(board.tell(read(fact))); }
  Result<Revision> transact(Board& board, Transaction transaction) {
    return wall->run(board.transact(std::move(transaction)));
  }
  std::vector<Answer> ask(Board& board, const std::string& text) {
    Result<Answers> answers = wall->run(board.ask(query(text)));
    EXPECT_TRUE(answers.has_value()) << text << ": " << answers.error().sentence;
    return answers ? answers->answers : std::vector<Answer>();
  }
  bool holds(Board& board, const std::string& pattern) { return !ask(board, pattern).empty(); }
  // Whether the board removes it, or puts it back, by itself within ten seconds.
  bool lapses(Board& board, const std::string& pattern) { return comes_to(board, pattern, false); }
  bool comes_back(Board& board, const std::string& pattern) { return comes_to(board, pattern, true); }
  std::unique_ptr<Watch> watch(Board& board, const std::string& text) {
    Result<std::unique_ptr<Watch>> watch = wall->run(board.watch(query(text)));
    EXPECT_TRUE(watch.has_value());
    return watch ? std::move(*watch) : nullptr;
  }
  Change next(Watch& watch) {
    Result<Change> change = wall->run(watch.next());
    EXPECT_TRUE(change.has_value()) << change.error().sentence;
    return change.value_or(Change());
  }

  std::unique_ptr<Wall> wall;
  std::unique_ptr<Board> alice;
  std::unique_ptr<Board> bob;

 private:
  bool comes_to(Board& board, const std::string& pattern, bool held) {
    for (int looks = 0; looks < 200 && holds(board, pattern) != held; ++looks) wall->pass(50ms);
    return holds(board, pattern) == held;
  }
};

inline std::string wall_name(const testing::TestParamInfo<WallKind>& tested) { return tested.param.name; }

// The values of one variable, in the answers' order.
inline std::vector<Datum> values(const std::vector<Answer>& answers, const std::string& variable) {
  std::vector<Datum> values;
  for (const Answer& answer : answers) values.push_back(*answer.bindings.find(variable));
  return values;
}

inline std::string symbol_of(const auto& result) { return result.has_value() ? "ok" : result.error().symbol; }

}  // namespace pizarra
