#pragma once

// A vision agent before a camera of three faces, and clients who ask it: what its tests stand on.
//
//   TEST_F(Vision, Finds) { learn_all(); EXPECT_NE(call("(find \"circle\")"), ""); }
//
// All in virtual time.

#include <gtest/gtest.h>

#include "agents/runtime/caller.hpp"
#include "agents/vision/agent/vision_agent.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/vision/fake_camera.hpp"

namespace pizarra::vision {

inline Datum form(std::string_view written) { return read_one(written).value(); }

// One life of the agent: destroying it is its death.
class VisionLife {
 public:
  VisionLife(Executor& executor, memory::MemoryBoard& board, camera::StereoCamera& camera, Streams* streams,
             VisionOptions options, const std::string& name = "vision")
      : view_(board.view(name)),
        agent_({name, "here", executor, *view_, Random(1)}, camera, streams, std::move(options)) {
    job_ = executor.spawn(live());
  }

 private:
  Task<void> live() {
    const Result<void> ended = co_await agent_.run();
    EXPECT_TRUE(ended.has_value()) << describe(ended.error());
  }
  std::unique_ptr<Board> view_;
  VisionAgent agent_;
  Job job_;
};

class Vision : public testing::Test {
 protected:
  Vision() {
    camera.scene.faces = {{.mark = "circle", .place = {-100, 0, 850}},
                          {.mark = "square", .place = {0, 0, 850}},
                          {.mark = "plate", .place = {100, 0, 840}}};
    const Job started = executor.spawn(start());
    executor.run_until([&] { return started.done(); });
    live();
  }
  void live(const std::string& objects = "") {
    life.emplace(executor, board, camera, &streams, VisionOptions{.objects_directory = objects});
  }
  Task<void> start() {
    const Result<void> present = co_await service.start();
    EXPECT_TRUE(present.has_value());
  }

  // The text that was answered, "()" where there is none, or the failure's symbol and subject.
  std::string call(const std::string& operation, Duration timeout = 20s, const std::string& agent = "vision") {
    std::string answer;
    const Job job = executor.spawn(ask(agent, form(operation), timeout, answer));
    executor.run_until([&] { return job.done(); });
    return answer;
  }
  Task<void> ask(std::string agent, Datum operation, Duration timeout, std::string& answer) {
    const Result<Datum> result = co_await caller.call(agent, operation, timeout);
    answer = shown(result);
  }
  void run_for(Duration duration) {
    const Time end = executor.now() + duration;
    executor.call_at(end, [] {});
    executor.run_until([&] { return executor.now() >= end; });
  }
  // Every fact that fits, as written, one a line.
  std::string facts(std::string_view pattern) {
    std::string out;
    const Answers answers = board.ask(query_from_datum(form(pattern)).value()).value();
    for (const Answer& answer : answers.answers) {
      if (!out.empty()) out += "\n";
      out += write(answer.facts.front().datum);
    }
    return out;
  }
  void tell(const Datum& fact) {
    const Job job = executor.spawn(tell_task(fact));
    executor.run_until([&] { return job.done(); });
  }
  Task<void> tell_task(Datum fact) {
    const Result<Revision> told = co_await view->tell(fact);
    EXPECT_TRUE(told.has_value());
  }
  void retract(std::string_view pattern) {
    const Job job = executor.spawn(retract_task(form(pattern)));
    executor.run_until([&] { return job.done(); });
  }
  Task<void> retract_task(Datum pattern) {
    const Result<Revision> retracted = co_await view->retract(pattern);
    EXPECT_TRUE(retracted.has_value());
  }
  std::string learn_request(std::size_t face, const std::string& name) {
    const cv::Point2d at = project(camera.model(), camera.scene.faces[face].place, false);
    return write(list("learn"_sym, at.x, at.y, name));
  }
  void learn_all() {
    EXPECT_EQ(call(learn_request(0, "circle")), R"x((LEARN "circle" OK))x");
    EXPECT_EQ(call(learn_request(2, "end-effector")), R"x((LEARN "end-effector" OK))x");
  }
  std::string says() {
    const Answers answers = board.ask(query_from_datum(form("(look vision ?frame ?text ?of)")).value()).value();
    if (answers.answers.empty()) return "nothing";
    return std::string(answers.answers[0].bindings.find("?text")->text());
  }

  // Another client, present until it is destroyed.
  struct Client {
    Client(Vision& room, const std::string& name)
        : fixture(room), view(room.board.view(name)), context{name, "here", room.executor, *view, Random(3)} {
      const Job started = fixture.executor.spawn(start());
      fixture.executor.run_until([&] { return started.done(); });
    }
    Task<void> start() {
      const Result<void> present = co_await service.start();
      EXPECT_TRUE(present.has_value());
    }
    std::string call(const std::string& operation) {
      std::string answer;
      const Job job = fixture.executor.spawn(ask(form(operation), answer));
      fixture.executor.run_until([&] { return job.done(); });
      return answer;
    }
    Task<void> ask(Datum operation, std::string& answer) {
      const Result<Datum> result = co_await caller.call("vision", operation, 20s);
      answer = Vision::shown(result);
    }
    Vision& fixture;
    std::unique_ptr<Board> view;
    runtime::AgentContext context;
    runtime::Service service{context, runtime::contract_from_text("(contract client)").value()};
    runtime::Caller caller{context, service};
  };
  static std::string shown(const Result<Datum>& result) {
    if (!result) return result.error().symbol + " " + write(result.error().subject);
    const bool has_text = result->size() == 1 || gives_reason(*result);
    return has_text ? std::string((*result)[0].text()) : write(*result);
  }
  // (TEXT SYMBOL SENTENCE), where TEXT says FAIL.
  static bool gives_reason(const Datum& reply) {
    if (reply.size() != 3 || !reply[1].is_symbol() || !reply[2].is_string()) return false;
    return reply[0].is_string() && reply[0].text().ends_with(" FAIL)");
  }
  static Task<void> tell(Board& teller, Datum fact) {
    const Result<Revision> told = co_await teller.tell(fact);
    EXPECT_TRUE(told.has_value());
  }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  LocalStreams streams;
  FakeCamera camera{executor, 7};
  std::unique_ptr<Board> view = board.view("tester");
  runtime::AgentContext context{"tester", "here", executor, *view, Random(2)};
  runtime::Service service{context, runtime::contract_from_text("(contract tester)").value()};
  runtime::Caller caller{context, service};
  std::optional<VisionLife> life;
};

}  // namespace pizarra::vision
