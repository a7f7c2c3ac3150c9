#include "agents/runtime/patterns/heavy_light.hpp"

#include <algorithm>

#include "lisp/reader.hpp"

namespace pizarra::runtime {

namespace {

// A server may come late to the stream, or be busy with the frame before.
constexpr Duration publish_again = 100ms;
// Whether the server's presence began anew, and what stood under it has to be told again.
constexpr Duration server_look = 500ms;

Task<Result<void>> declare_heavy_light(Board& board) {
  const std::vector<Relation> relations = heavy_light_relations();
  co_return co_await board.declare(relations);
}

}  // namespace

std::vector<Relation> heavy_light_relations() {
  constexpr std::string_view forms[] = {
      "(relation ready-for ((stream symbol) (server symbol)))",
      "(relation light-answer ((stream symbol) (frame integer) (server symbol) (value datum)) (key stream frame server)"
      " (lease 10000))",
  };
  std::vector<Relation> relations{stream_relation()};
  for (const std::string_view form : forms) relations.push_back(relation_from_datum(read_one(form).value()).value());
  return relations;
}

HeavyServer::HeavyServer(AgentContext& context, const Service& service, Streams& streams, std::string stream, Work work)
    : context_(context),
      service_(service),
      streams_(streams),
      stream_(std::move(stream)),
      work_(std::move(work)),
      come_(context.executor) {}

Task<Result<void>> HeavyServer::serve() {
  const Result<void> declared = co_await declare_heavy_light(context_.board);
  if (!declared) co_return declared;
  const auto subscription = streams_.subscribe(stream_, [this](const StreamFrame& frame) {
    newest_ = frame;
    come_.set();
  });
  std::uint64_t answered = 0;
  LeaseId told_under = 0;
  while (true) {
    const LeaseId presence = service_.presence();
    const bool known = told_under == presence;
    if (!known) {
      const Result<void> told = co_await say_ready();
      if (told) told_under = presence;
    }
    const Time look_up = context_.executor.now() + server_look;
    const bool come = co_await come_.wait(look_up);
    if (!come) continue;
    come_.reset();
    const StreamFrame frame = *newest_;
    // Published once more for others.
    if (frame.number == answered) continue;
    const Result<void> said = co_await answer(frame);
    if (said) answered = frame.number;
  }
}

Task<Result<void>> HeavyServer::say_ready() {
  Transaction ready;
  ready.tell(list("ready-for"_sym, Datum::symbol(stream_), Datum::symbol(context_.name)), {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(ready));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<void>> HeavyServer::answer(StreamFrame frame) {
  const Datum value = co_await work_(frame);
  const Datum fact = list("light-answer"_sym, Datum::symbol(stream_), static_cast<std::int64_t>(frame.number),
                          Datum::symbol(context_.name), value);
  const Result<Revision> told = co_await context_.board.tell(fact);
  if (!told) co_return fail(told);
  co_return Result<void>();
}

HeavyAsker::HeavyAsker(AgentContext& context, const Service& service, Streams& streams, std::string stream)
    : context_(context), service_(service), streams_(streams), stream_(std::move(stream)) {}

Task<Result<void>> HeavyAsker::announce() {
  const Result<void> declared = co_await declare_heavy_light(context_.board);
  if (!declared) co_return declared;
  Transaction announcing;
  announcing.tell(stream_fact(stream_, "heavy", streams_), {}, service_.presence());
  const Result<Revision> told = co_await context_.board.transact(std::move(announcing));
  if (!told) co_return fail(told);
  co_return Result<void>();
}

Task<Result<std::vector<LightAnswer>>> HeavyAsker::ask(StreamFrame frame, Duration patience) {
  const Time deadline = context_.executor.now() + patience;
  // Told again, which changes nothing unless it went with the asker's presence.
  const Result<void> announced = co_await announce();
  if (!announced) co_return fail(announced);
  const Datum anybody = list("ready-for"_sym, Datum::symbol(stream_), "?server"_sym);
  const Result<std::vector<Fact>> ready = co_await context_.board.facts(anybody);
  if (!ready) co_return fail(ready);
  streams_.publish(stream_, frame);
  std::vector<LightAnswer> answers;
  for (const Fact& fact : *ready) {
    const Result<Answer> answer = co_await await_one(frame, fact.datum[2], deadline);
    const bool silent = !answer && answer.error().symbol == "timeout";
    if (silent) continue;
    if (!answer) co_return fail(answer);
    answers.push_back({std::string(fact.datum[2].text()), answer->facts.front().datum[4]});
  }
  std::ranges::sort(answers, {}, &LightAnswer::server);
  co_return answers;
}

Task<Result<Answer>> HeavyAsker::await_one(StreamFrame frame, Datum server, Time deadline) {
  const Query query = query_for(
      list("light-answer"_sym, Datum::symbol(stream_), static_cast<std::int64_t>(frame.number), server, "?value"_sym));
  while (true) {
    const Time look_up = std::min(deadline, context_.executor.now() + publish_again);
    const Result<Answer> answer = co_await await_answer(context_.board, query, look_up, context_.executor);
    const bool wait_on = !answer && answer.error().symbol == "timeout" && look_up < deadline;
    if (!wait_on) co_return answer;
    streams_.publish(stream_, frame);
  }
}

}  // namespace pizarra::runtime
