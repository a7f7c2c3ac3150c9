#include "programs/story/narrator.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <unistd.h>
#include <utility>

#include "agents/runtime/declared.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "lisp/writer.hpp"

namespace pizarra::story {

namespace {

// Longer than an agent takes to find that the board has forgotten it.
constexpr Duration return_pause = 5s;

// The call itself waits some seconds for a board before it fails.
constexpr Duration ask_again_after = 500ms;

// A board that is not there yet, or whose log has no quorum.
bool may_come(const Failure& failure) { return failure.symbol == "unreachable" || failure.symbol == "unavailable"; }

// Colours by what a line is about: surprises stand out, the servo's many lines step back.
const char* colour_of(std::string_view kind) {
  static const std::map<std::string_view, const char*> colours{
      {"seen", "\x1b[36m"},   {"plan", "\x1b[1;34m"},       {"operation", "\x1b[1m"},  {"servo", "\x1b[2m"},
      {"hand", "\x1b[1;35m"}, {"difference", "\x1b[1;33m"}, {"result", "\x1b[1;32m"},  {"failure", "\x1b[1;31m"},
      {"agent", "\x1b[33m"},  {"goal", "\x1b[1;34m"},       {"refused", "\x1b[1;31m"},
  };
  const auto found = colours.find(kind);
  return found == colours.end() ? "" : found->second;
}

// The thesis' five states of the visual servo.
std::string servo_sentence(const Datum& servo) {
  static constexpr std::string_view states[] = {"goes up", "aligns sideways", "aligns in depth", "approaches",
                                                "aligns finely"};
  const auto state = static_cast<std::size_t>(std::clamp<std::int64_t>(servo[1].integer(), 0, 4));
  return fmt::format("{} {} on {}: {:+.1f} px, {:+.1f} px, {:+.1f} mm", state, states[state], servo[2].text(),
                     servo[3].number(), servo[4].number(), servo[5].number());
}

// Those who only talk to the cell come and go without being part of its story.
bool is_visitor(const Datum& agent) { return agent[2].is_symbol("prompt") || agent[2].is_symbol("director"); }

double seconds(Duration duration) { return static_cast<double>(duration.count()) / 1e6; }

}  // namespace

Narrator::Style Narrator::style_for(std::FILE* out, bool json) {
  if (json) return Style::json;
  const bool terminal = isatty(fileno(out)) == 1 && std::getenv("NO_COLOR") == nullptr;
  return terminal ? Style::colour : Style::plain;
}

void Narrator::say(Time when, std::string_view kind, std::string_view said, const Datum& detail) {
  const std::string sentence = lines_of_bytes(said);
  const double at_s = seconds(when - start_);
  newest_ = fmt::format("{:6.1f} s  {:<10}  {}", at_s, kind, sentence);
  switch (style_) {
    case Style::silent:
      return;
    case Style::plain:
      fmt::print(out_, "{}\n", newest_);
      break;
    case Style::colour:
      fmt::print(out_, "\x1b[2m{:6.1f} s\x1b[0m  {}{:<10}  {}\x1b[0m\n", at_s, colour_of(kind), kind, sentence);
      break;
    case Style::json:
      fmt::print(out_, "{{\"time_s\":{:.3f},\"kind\":{},\"sentence\":{},\"detail\":{}}}\n", at_s, json_string(kind),
                 json_string(sentence), json_string(write(detail)));
      break;
  }
  std::fflush(out_);
}

void Narrator::tell_added(const Fact& fact) {
  const Datum& datum = fact.datum;
  if (datum.is_form("event")) {
    if (datum[1].integer() <= last_event_) return;
    last_event_ = datum[1].integer();
    say(fact.when, datum[2].text(), datum[3].text(), datum[4]);
    return;
  }
  if (datum.is_form("servo")) {
    const Datum state = list(datum[1], datum[2]);
    if (state == last_servo_) return;
    last_servo_ = state;
    say(fact.when, "servo", servo_sentence(datum), datum);
    return;
  }
  if (datum.is_form("person")) {
    if (datum == last_person_) return;
    last_person_ = datum;
    if (datum[1].is_symbol("done")) say(fact.when, "person", "everything is taught: ready for goals", datum);
    if (datum[1].is_symbol("failed")) say(fact.when, "failure", describe(failure_from_datum(datum[2])), datum);
    return;
  }
  if (datum.is_form("camera-state")) {
    const std::string sentence = camera_news_.sentence_of(datum);
    if (!sentence.empty()) say(fact.when, datum[2].is_symbol("lost") ? "failure" : "agent", sentence, datum);
    return;
  }
  if (is_visitor(datum)) return;
  missing_.erase(datum);
  if (present_.insert(datum).second) say(fact.when, "agent", fmt::format("{} is there", datum[1].text()), datum);
}

Task<void> Narrator::tell_who_stays_away(Executor& executor) {
  co_await sleep(executor, return_pause);
  for (const Datum& agent : std::exchange(missing_, {})) {
    present_.erase(agent);
    say(executor.now(), "agent", fmt::format("{} is gone", agent[1].text()), agent);
  }
}

void Narrator::tell_change(const Change& change, Executor& executor) {
  std::vector<Fact> added;
  for (const Answer& answer : change.added) added.push_back(answer.facts.front());
  std::ranges::sort(added, {}, &Fact::id);
  for (const Answer& answer : change.removed) {
    const Datum& datum = answer.facts.front().datum;
    missing_.erase(datum);
    if (present_.erase(datum) == 0) continue;
    say(executor.now(), "agent", fmt::format("{} is gone", datum[1].text()), datum);
  }
  for (const Fact& fact : added) tell_added(fact);
}

// Several patterns wait for one board: it is told once.
Task<Result<std::unique_ptr<Watch>>> Narrator::watch_when_there(Board& board, Executor& executor, Datum pattern) {
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(board, query_for(pattern));
    if (watch && !std::exchange(away_, "").empty()) say(executor.now(), "board", "the board answers");
    if (watch || !may_come(watch.error())) co_return watch;
    const std::string why = describe(watch.error());
    if (std::exchange(away_, why) != why) say(executor.now(), "board", why + ": waiting for it");
    co_await sleep(executor, ask_again_after);
  }
}

Task<void> Narrator::follow_pattern(Board& board, Executor& executor, Datum pattern) {
  const Result<std::unique_ptr<Watch>> watch = co_await watch_when_there(board, executor, pattern);
  if (!watch) {
    say(executor.now(), "failure", describe(watch.error()));
    co_return;
  }
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) {
      say(executor.now(), "failure", describe(change.error()));
      co_return;
    }
    const bool agents_anew = change->resynchronised && pattern.is_form("agent");
    if (agents_anew) missing_ = present_;
    tell_change(*change, executor);
    if (agents_anew && !missing_.empty()) waiting_ = executor.spawn(tell_who_stays_away(executor));
  }
}

Task<void> Narrator::follow(Board& board, Executor& executor) {
  const Job agents = executor.spawn(follow_pattern(board, executor, list("agent"_sym, "?"_sym, "?"_sym, "?"_sym)));
  const Job person = executor.spawn(follow_pattern(board, executor, list("person"_sym, "?"_sym, "?"_sym)));
  const Datum camera_states = list("camera-state"_sym, "?"_sym, "?"_sym, "?"_sym);
  const Job cameras = executor.spawn(follow_pattern(board, executor, camera_states));
  const Datum servo_states = list("servo"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  const Job servo = executor.spawn(follow_pattern(board, executor, servo_states));
  const Datum events = list("event"_sym, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
  co_await follow_pattern(board, executor, events);
}

}  // namespace pizarra::story
