#include "agents/speech/speech_agent.hpp"

#include "lisp/forms/sentence.hpp"
#include "lisp/writer.hpp"

namespace pizarra::speech {

namespace {

constexpr const char* contract_text = R"((contract speech
  (offers (say (sentence string)))
  (posts (relation wired ((client symbol) (role symbol) (server symbol)) (key client role) (durable))
         (relation holder ((client symbol) (role symbol) (server symbol) (state symbol)) (key client role)))
  (reads agent bound wired)))";

constexpr Duration longest_motion = 60s;

}  // namespace

SpeechAgent::SpeechAgent(runtime::AgentContext context)
    : context_(std::move(context)),
      service_(context_, runtime::contract_from_text(contract_text).value()),
      caller_(context_, service_),
      roles_(context_, service_, {runtime::robot_role(), runtime::coordinator_role()}) {}

Task<Result<void>> SpeechAgent::run() {
  const Result<void> started = co_await service_.start();
  if (!started) co_return started;
  roles_.start();
  runtime::Handler handler = [this](Datum operation) { return say(std::move(operation)); };
  co_return co_await service_.serve(std::move(handler));
}

Task<Result<Datum>> SpeechAgent::say(Datum operation) {
  const Result<forms::Sentence> meant = forms::read_sentence(operation[1].text());
  if (!meant) co_return fail(meant);
  const Result<Datum> done = co_await caller_.call(roles_.player(meant->agent), meant->operation, longest_motion);
  if (!done) co_return fail(done);
  std::vector<Datum> answer{Datum::string(write(meant->operation))};
  answer.insert(answer.end(), done->items().begin(), done->items().end());
  co_return Datum::list(std::move(answer));
}

}  // namespace pizarra::speech
