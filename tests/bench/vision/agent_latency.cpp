#include "tests/bench/vision/agent_latency.hpp"

#include <stdexcept>

#include "agents/runtime/caller.hpp"
#include "agents/vision/database/object_database.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/vision/learned_marks.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {
namespace {

constexpr int first_counted = 100;
constexpr Duration patience = 60s;
// Looks at no image, which the eyes tell where none came in time: a busy machine may bring it late.
constexpr int most_without_image = 100;

double ms(const std::vector<double>& us, double part) {
  return 1e-3 * percentile(std::span(us).subspan(std::min<std::size_t>(first_counted, us.size())), part);
}

// The facts that an agent tells of a frame, as large and as often anew, under names of the bench's own.
class Echo {
 public:
  static constexpr std::string_view contract = R"((contract bench
    (posts (relation bench-look ((frame integer) (text string) (of list)) (key)))))";

  Echo(Board& board, LeaseId lease) : board_(board), lease_(lease) {}

  Task<Result<void>> begin() {
    const Query said = query_for(list("bench-look"_sym, "?frame"_sym, "?text"_sym, "?of"_sym));
    Result<std::unique_ptr<Watch>> heard = co_await board_.watch(said);
    if (!heard) co_return fail(heard);
    heard_ = std::move(*heard);
    const Result<Change> nothing_yet = co_await heard_->next();
    if (!nothing_yet) co_return fail(nothing_yet);
    co_return Result<void>();
  }
  // Until it is heard.
  Task<Result<void>> tell(Datum frame, Datum text, Datum of) {
    Transaction look;
    look.tell(list("bench-look"_sym, frame, text, of), {}, lease_);
    const Result<Revision> told = co_await board_.transact(std::move(look));
    if (!told) co_return fail(told);
    const Result<Change> heard = co_await heard_->next();
    if (!heard) co_return fail(heard);
    co_return Result<void>();
  }

 private:
  Board& board_;
  LeaseId lease_;
  std::unique_ptr<Watch> heard_;
};

Task<Result<void>> track_all(runtime::Caller& caller, const vision::LearnedObjects& marks) {
  for (const vision::LearnedObject& object : marks.all()) {
    const Datum operation = list("track"_sym, object.name);
    const Result<Datum> tracked = co_await caller.call("vision", operation, patience);
    if (!tracked) co_return fail(tracked);
  }
  co_return Result<void>();
}

Task<Result<Latencies>> measure(runtime::AgentContext& context, const vision::LearnedObjects& marks,
                                const LatencyClock& clock) {
  runtime::Service service(context, runtime::contract_from_text(Echo::contract).value());
  const Result<void> started = co_await service.start();
  if (!started) co_return fail(started);
  runtime::Caller caller(context, service);
  const Result<void> tracked = co_await track_all(caller, marks);
  if (!tracked) co_return fail(tracked);
  const Query said = query_for(list("look"_sym, "vision"_sym, "?frame"_sym, "?text"_sym, "?of"_sym));
  const Result<std::unique_ptr<Watch>> words = co_await context.board.watch(said);
  if (!words) co_return fail(words);
  std::optional<Echo> echo;
  Latencies out;
  int without_image = 0;
  while (out.track_us.size() < latency_frames) {
    const Result<Change> change = co_await (*words)->next();
    const double seen_us = clock.now_us();
    if (!change) co_return fail(change);
    if (change->added.empty()) continue;
    const Datum fact = change->added.back().facts.front().datum;
    const std::string text(fact[3].text());
    const bool has_image = text.contains(" OK ");
    if (!has_image && ++without_image <= most_without_image) continue;
    if (text.contains("FAIL")) co_return fail("not-measured", "a mark was lost: " + text);
    if (!echo) {
      echo.emplace(context.board, service.presence());
      const Result<void> begun = co_await echo->begin();
      if (!begun) co_return fail(begun);
      continue;
    }
    out.track_us.push_back(seen_us - clock.arrival_us(static_cast<std::uint64_t>(fact[2].integer())));
    const double before_us = clock.now_us();
    const Result<void> heard = co_await echo->tell(fact[2], fact[3], fact[4]);
    if (!heard) co_return fail(heard);
    out.board_us.push_back(clock.now_us() - before_us);
  }
  co_return out;
}

}  // namespace

double Latencies::track_ms(double part) const { return ms(track_us, part); }
double Latencies::board_ms(double part) const { return ms(board_us, part); }

Latencies latencies(Executor& executor, Board& board, const vision::LearnedObjects& marks, const LatencyClock& clock) {
  runtime::AgentContext context{"bench", "here", executor, board, Random(2)};
  Result<Latencies> took = run(executor, measure(context, marks, clock));
  if (!took) throw std::runtime_error(describe(took.error()));
  return std::move(*took);
}

std::vector<Shot> moving_marks(std::uint64_t seed) {
  std::vector<Shot> out;
  Random random(seed);
  for (const double step : {0.0, 1.3, 3.1, 4.7, 3.6, 1.8}) {
    Scene scene = learning_scene();
    scene.noise = 5;
    for (SceneMark& mark : scene.marks) mark.centre += cv::Point2d(-step, 0.5 * step);
    const cv::Mat1b left = draw(scene, Side::left, random);
    out.push_back({left, draw(scene, Side::right, random)});
  }
  return out;
}

std::string objects_folder(const TemporaryFolder& folder, const vision::LearnedObjects& marks) {
  std::string path = folder.path() + "/objects";
  vision::ObjectDatabase database = vision::ObjectDatabase::open(path).value();
  for (const vision::LearnedObject& object : marks.all()) {
    const Result<std::int64_t> kept = database.apply(vision::KeepSample{object.name, object.samples.front()});
    if (!kept) throw std::runtime_error(describe(kept.error()));
  }
  return path;
}

}  // namespace pizarra::bench
