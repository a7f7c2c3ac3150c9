#pragma once

// An agent that answers who it is, on any wall: destroying it is its death.
//
//   Member robot(*wall, "robot-1", "robot", "bench");
//   robot.enter();
//   robot.ask("robot-2", "(where)");                  // (ok "desk")

#include <optional>

#include "agents/runtime/caller.hpp"
#include "agents/runtime/naming.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra::runtime {

// The walls on which C++ agents stand.
inline std::vector<WallKind> agent_walls() {
  std::vector<WallKind> walls;
  for (WallKind& wall : all_walls()) {
    if (wall.name == "memory" || wall.name == "ipc") walls.push_back(std::move(wall));
  }
  return walls;
}

class Member {
 public:
  Member(Wall& wall, const std::string& name, const std::string& kind, const std::string& host = "here")
      : wall_(wall),
        board_(wall.view(name)),
        context{name, host, wall.executor(), *board_, Random(1)},
        service(context,
                contract_from_text("(contract " + kind + " (offers (where) (slow) (take-note (text datum))))").value()),
        caller(context, service),
        naming(context, service) {}

  // Present and serving. One that must wait for its name does so by itself.
  void enter() {
    begin();
    wall_.run(entered());
  }
  void begin() { job_ = wall_.executor().spawn(live()); }
  bool is_in() const { return in_; }

  Result<Datum> ask(const std::string& agent, const std::string& operation, Duration patience = 8s) {
    return wall_.run(caller.call(agent, read(operation), patience));
  }
  template <class T>
  T run(Task<T> task) {
    return wall_.run(std::move(task));
  }

  std::vector<Datum> notes;  // what it was told, in order

 private:
  Task<void> live() {
    const Result<void> started = co_await service.start();
    EXPECT_TRUE(started.has_value());
    const Result<void> declared = co_await naming.declare();
    EXPECT_TRUE(declared.has_value());
    in_ = true;
    const Handler handler = [this](Datum operation) { return handle(std::move(operation)); };
    const Result<void> served = co_await service.serve(handler);
    EXPECT_TRUE(served.has_value());
  }
  Task<bool> entered() {
    while (!in_) co_await sleep(context.executor, 1ms);
    co_return true;
  }
  Task<Result<Datum>> handle(Datum operation) {
    if (operation.is_form("slow")) co_await sleep(context.executor, 300ms);
    if (operation.is_form("take-note")) notes.push_back(operation[1]);
    co_return list(context.host);
  }

  Wall& wall_;
  std::unique_ptr<Board> board_;
  bool in_ = false;

 public:
  AgentContext context;
  Service service;
  Caller caller;
  Naming naming;

 private:
  Job job_;
};

}  // namespace pizarra::runtime
