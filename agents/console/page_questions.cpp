#include "agents/console/page_questions.hpp"

#include <algorithm>

#include "agents/console/change_text.hpp"
#include "agents/runtime/declared.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

constexpr ReadLimits query_limits{.bytes = web::WebSocket::max_message, .depth = 32, .elements = 4000};

}  // namespace

void PageQuestions::follow(const Datum& form) {
  const std::int64_t number = form[1].integer();
  Result<Query> query = query_from_datum(form[2]);
  if (!query) return voice_.say(failed_watch_text(number, query.error()));
  add_watch(number, std::move(*query), true);
}

void PageQuestions::watch(const Datum& form) {
  const std::int64_t number = form[1].integer();
  const Result<Source> source = read_source(form[2].text(), "query", query_limits);
  if (!source) return voice_.say(failed_watch_text(number, source.error()));
  if (source->data().size() != 1) {
    return voice_.say(failed_watch_text(number, {"malformed", "a query is one form, as (on ?x ?y)", {}, {}}));
  }
  Result<Query> query = query_from_datum(source->data().front());
  if (!query) return voice_.say(failed_watch_text(number, query.error()));
  add_watch(number, std::move(*query), false);
}

void PageQuestions::unwatch(const Datum& form) { watches_.erase(form[1].integer()); }

void PageQuestions::add_watch(std::int64_t number, Query query, bool when_declared) {
  std::erase_if(watches_, [](const auto& entry) { return entry.second.done(); });
  if (watches_.size() >= max_watches || watches_.contains(number)) {
    return voice_.say(failed_watch_text(number, {"too-many", "too many questions are watched already", {}, {}}));
  }
  watches_.emplace(number, board_.executor().spawn(start_watch(number, std::move(query), when_declared)));
}

Task<void> PageQuestions::start_watch(std::int64_t number, Query query, bool when_declared) {
  Result<std::unique_ptr<Watch>> watch = fail("unreachable", "not asked yet");
  if (when_declared) {
    watch = co_await runtime::watch_when_declared(board_.facts(), std::move(query));
  } else {
    watch = co_await board_.facts().watch(std::move(query));
  }
  if (!watch) {
    voice_.say(failed_watch_text(number, watch.error()));
    co_return;
  }
  co_await send_changes(number, std::move(*watch));
}

Task<void> PageQuestions::send_changes(std::int64_t number, std::unique_ptr<Watch> watch) {
  while (true) {
    const Result<Change> change = co_await watch->next();
    if (!change) {
      voice_.say(failed_watch_text(number, change.error()));
      co_return;
    }
    co_await voice_.room();
    voice_.say_fact(change_text(number, *change));
  }
}

void PageQuestions::ask(const Datum& form) {
  const std::int64_t number = form[1].integer();
  const Result<Query> query = query_from_datum(form[2]);
  if (!query) return voice_.say(failed_watch_text(number, query.error()));
  requests_.begin(number, ask_now(number, *query));
}

Task<void> PageQuestions::ask_now(std::int64_t number, Query query) {
  const Result<Answers> answers = co_await runtime::answers_if_declared(board_.facts(), std::move(query));
  if (!answers) {
    voice_.say(failed_watch_text(number, answers.error()));
    co_return;
  }
  const Change change{answers->revision, true, answers->answers, {}};
  co_await voice_.room();
  voice_.say_fact(change_text(number, change));
}

void PageQuestions::then(const Datum& form) {
  const std::int64_t number = form[1].integer();
  const Result<Query> read = query_from_datum(form[2]);
  if (!read) return voice_.refuse(number, read.error().symbol, read.error().sentence);
  Query query = *read;
  query.at = Moment{};
  query.at->time = Time(Duration(std::max<std::int64_t>(0, form[3].integer())));
  requests_.begin(number, ask_then(number, std::move(query)));
}

Task<void> PageQuestions::ask_then(std::int64_t number, Query query) {
  const std::string past = std::to_string(query.at->time.time_since_epoch().count());
  Result<Answers> answers = co_await board_.facts().ask(std::move(query));
  if (!answers) {
    voice_.say(of_the_past(failed_watch_text(number, answers.error()), past));
    co_return;
  }
  const Change change{answers->revision, true, std::move(answers->answers), {}};
  co_await voice_.room();
  voice_.say_fact(of_the_past(change_text(number, change), past));
  arms_.say(change.added, past);
}

}  // namespace pizarra::console
