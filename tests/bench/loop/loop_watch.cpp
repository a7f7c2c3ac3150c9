#include "tests/bench/loop/loop_watch.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>

#include "agents/runtime/declared.hpp"

namespace pizarra::bench {

namespace {

// Short enough for the fingers to be still some millimetres from the cube, long enough for a speed to show.
constexpr Duration glance = 25ms;
constexpr Duration patience = 2s;

std::map<std::string, Eigen::Vector3d> places_in(const Datum& truth) {
  std::map<std::string, Eigen::Vector3d> places;
  for (const Datum& item : truth.items()) {
    if (!item.is_form("cube")) continue;
    places[std::string(item[1].text())] = {item[2].number(), item[3].number(), item[4].number()};
  }
  return places;
}

double longest_way_mm(const Datum& before, const Datum& after) {
  const std::map<std::string, Eigen::Vector3d> later = places_in(after);
  double longest_mm = 0;
  for (const auto& [cube, place] : places_in(before)) {
    const auto found = later.find(cube);
    if (found != later.end()) longest_mm = std::max(longest_mm, (found->second - place).norm());
  }
  return longest_mm;
}

}  // namespace

Task<void> LoopWatch::follow(launcher::LocalCell& cell) {
  cell_ = &cell;
  const std::unique_ptr<Board> board = cell.board().view("bench");
  const Datum any = "?"_sym;
  const Datum steps = list("micro-task"_sym, any, any, any);
  const Job carries = cell.executor().spawn(follow_pattern(*board, cell.executor(), steps));
  const Datum openings = list("gripper"_sym, any, any);
  const Job fingers = cell.executor().spawn(follow_pattern(*board, cell.executor(), openings));
  const Datum events = list("event"_sym, any, any, any, any);
  co_await follow_pattern(*board, cell.executor(), events);
}

Task<void> LoopWatch::follow_pattern(Board& board, Executor& executor, Datum pattern) {
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(board, query_for(pattern));
  while (watch) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    const double now_s = static_cast<double>(executor.now().time_since_epoch().count()) / 1e6;
    for (const Answer& answer : change->added) take(answer.facts.front().datum, now_s);
  }
}

void LoopWatch::take(const Datum& fact, double now_s) {
  if (fact.is_form("gripper")) return retry_watch_.take(fact, now_s);
  if (fact.is_form("micro-task")) retry_watch_.take(fact, now_s);
  if (fact.is_form("micro-task")) return take_micro_task(fact, now_s);
  if (fact[1].integer() <= last_event_) return;
  last_event_ = fact[1].integer();
  retry_watch_.take(fact, now_s);
  take_event(fact, now_s);
}

void LoopWatch::take_micro_task(const Datum& task, double now_s) {
  if (task[2].is_form("close") && task[3].is_symbol("running")) grip_ = cell_->executor().spawn(measure_grip());
  if (task[2].is_form("close") && task[3].is_symbol("done")) grasped_s_ = now_s;
  if (!grasped_s_ || !task[2].is_form("release") || !task[3].is_symbol("running")) return;
  carries_s_.push_back(now_s - *grasped_s_);
  grasped_s_.reset();
}

Task<void> LoopWatch::measure_grip() {
  const Datum truth = list("truth"_sym);
  const Result<simulation::Message> before = co_await cell_->link().call(truth, patience);
  co_await sleep(cell_->executor(), glance);
  const Result<simulation::Message> after = co_await cell_->link().call(truth, patience);
  if (!before || !after) co_return;
  const double glance_s = std::chrono::duration<double>(glance).count();
  grips_mm_s_.push_back(longest_way_mm(before->head, after->head) / glance_s);
}

void LoopWatch::take_event(const Datum& event, double now_s) {
  if (event[2].is_symbol("difference") && !differed_s_) differed_s_ = now_s;
  if (event[2].is_symbol("plan") && event[4].is_form("plan")) take_plan(event[4], now_s);
  if (!event[2].is_symbol("operation")) return;
  const auto in_hand = std::ranges::find(left_, event[4]);
  if (in_hand != left_.end()) left_.erase(left_.begin(), in_hand);
}

void LoopWatch::take_plan(const Datum& plan, double now_s) {
  const std::vector<Datum> operations(plan[2].items().begin(), plan[2].items().end());
  if (differed_s_) {
    decisions_s_.push_back(now_s - *differed_s_);
    const auto goes_on = [&](const Datum& old) { return std::ranges::find(operations, old) != operations.end(); };
    if (!left_.empty()) {
      kept_.push_back(static_cast<double>(std::ranges::count_if(left_, goes_on)) / static_cast<double>(left_.size()));
    }
  }
  differed_s_.reset();
  left_ = operations;
}

}  // namespace pizarra::bench
