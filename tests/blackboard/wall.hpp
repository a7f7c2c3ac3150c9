#pragma once

// One of the walls, as the behaviour tests see it: boards for any number of tellers, and a way to let time pass.
//
//   std::unique_ptr<Wall> wall = make();
//   auto vision = wall->view("vision");
//   Result<Revision> told = wall->run(vision->tell(fact));

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "blackboard/board.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/executor.hpp"
#include "lisp/reader.hpp"

namespace pizarra {

class Wall {
 public:
  virtual ~Wall() = default;
  virtual Executor& executor() = 0;
  // A board of its own: for the wire, another connection.
  virtual std::unique_ptr<Board> view(const std::string& teller) = 0;

  // Runs until the task is done; the test hangs no longer than ten seconds.
  template <class T>
  T run(Task<T> task) {
    std::optional<T> result;
    const Job job = executor().spawn(keep(std::move(task), result));
    bool late = false;
    const auto timer = executor().call_at(executor().now() + 10s, [&] { late = true; });
    executor().run_until([&] { return result.has_value() || late; });
    executor().cancel(timer);
    if (!result) throw std::runtime_error("the task did not end");
    return std::move(*result);
  }

  // Whether it comes to hold within ten seconds.
  bool comes(const std::function<bool()>& holds) {
    bool late = false;
    const auto timer = executor().call_at(executor().now() + 10s, [&] { late = true; });
    executor().run_until([&] { return late || holds(); });
    executor().cancel(timer);
    return !late || holds();
  }

  void pass(Duration time) {
    bool passed = false;
    executor().call_at(executor().now() + time, [&] { passed = true; });
    executor().run_until([&] { return passed; });
  }

 private:
  template <class T>
  static Task<void> keep(Task<T> task, std::optional<T>& result) {
    T value = co_await task;
    result.emplace(std::move(value));
  }
};

struct WallKind {
  std::string name;
  std::function<std::unique_ptr<Wall>()> make;
};
// GoogleTest lists a parameter by this.
inline void PrintTo(const WallKind& kind, std::ostream* out) { *out << kind.name; }

std::vector<WallKind> all_walls();

// One that no other test of any process uses.
std::string ipc_address();

inline Datum read(const std::string& text) { return read_one(text).value(); }
inline Query query(const std::string& text) { return query_from_datum(read(text)).value(); }
inline Relation relation(const std::string& text) { return relation_from_datum(read(text)).value(); }

}  // namespace pizarra
