// A board in this process, without a wire: what one tell, one question by key, and a tell with its watcher cost, with
// 100,000 facts standing.

#include "blackboard/memory/memory_board.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/blackboard/board_process.hpp"
#include "tests/bench/blackboard/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr int objects = 100'000;
constexpr int operations = 20'000;  // in a round
constexpr int step = 7919;          // through the objects, so that neighbours do not come in turn

int object_of(int i) { return i * step % objects; }

class Household {
 public:
  Household() : board_(executor_), view_(board_.view("teller")) {
    if (!board_.declare("teller", {object_relation()})) throw std::runtime_error("the relation is refused");
    for (int i = 0; i < objects; ++i) run([&] { return tell(object_fact(i, 0)); });
  }
  double tells() {
    return each([this](int i) { return tell(object_fact(object_of(i), told_ + i)); });
  }
  double asks() {
    return each([this](int i) { return ask(object_name(object_of(i))); });
  }
  double watched_tells() {
    std::unique_ptr<Watch> watch;
    run([&] { return begin(watch); });
    return each([&](int i) { return tell_and_see(*watch, object_fact(object_of(i), told_ + i)); });
  }

 private:
  template <class Make>
  void run(Make&& make) {
    const Job job = executor_.spawn(make());
    executor_.run_until([&] { return job.done(); });
  }
  // The median of each one's time, in microseconds.
  template <class Make>
  double each(Make&& make) {
    took_us_.clear();
    // So that no fact is as it was.
    told_ += operations + 1;
    for (int i = 0; i < operations; ++i) run([&] { return make(i); });
    return percentile(took_us_, 0.5);
  }
  Task<void> tell(Datum fact) {
    const double begun = now_us();
    const Result<Revision> told = co_await view_->tell(std::move(fact));
    took_us_.push_back(now_us() - begun);
    if (!told) throw std::runtime_error(describe(told.error()));
  }
  Task<void> ask(Datum name) {
    Query query = query_for(list("seen"_sym, name, "?x"_sym, "?y"_sym, "?d"_sym));
    const double begun = now_us();
    const Result<Answers> answers = co_await view_->ask(std::move(query));
    took_us_.push_back(now_us() - begun);
    if (!answers || answers->answers.size() != 1) throw std::runtime_error("the board does not answer");
  }
  Task<void> begin(std::unique_ptr<Watch>& watch) {
    Query query = query_for(read_one("(seen ?name ?x ?y ?d)").value());
    Result<std::unique_ptr<Watch>> begun = co_await view_->watch(std::move(query));
    if (!begun) throw std::runtime_error(describe(begun.error()));
    watch = std::move(*begun);
    co_await watch->next();
  }
  Task<void> tell_and_see(Watch& watch, Datum fact) {
    const double begun = now_us();
    const Result<Revision> told = co_await view_->tell(std::move(fact));
    const Result<Change> change = co_await watch.next();
    took_us_.push_back(now_us() - begun);
    if (!told || !change || change->added.size() != 1) throw std::runtime_error("the watcher does not see it");
  }

  RealExecutor executor_;
  memory::MemoryBoard board_;
  std::unique_ptr<Board> view_;
  std::vector<double> took_us_;
  int told_ = 0;
};

}  // namespace

void in_process(Figures& figures) {
  Household household;
  const std::vector<double> us = medians_of_rounds(
      rounds,
      {[&] { return household.tells(); }, [&] { return household.asks(); }, [&] { return household.watched_tells(); }});
  figures.say({"in one process: tell, p50", us[0], "us", {}});
  figures.say({"in one process: ask by key, p50", us[1], "us", {}});
  figures.say({"in one process: tell and its watcher, p50", us[2], "us", {}});
}

}  // namespace pizarra::bench
