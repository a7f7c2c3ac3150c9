// What a page is shown: answers and their changes, arms, images; never more than it takes in.

#include <algorithm>
#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/session.hpp"
#include "agents/runtime/declared.hpp"
#include "drivers/arm/kinematics.hpp"
#include "lisp/reader.hpp"

namespace pizarra::console {

namespace {

constexpr ReadLimits query_limits{.bytes = WebSocket::max_message, .depth = 32, .elements = 4000};

std::string point_text(const Eigen::Vector3d& point) {
  return fmt::format("[{:.2f},{:.2f},{:.2f}]", point.x(), point.y(), point.z());
}

std::string direction_text(const Eigen::Vector3d& direction) {
  return fmt::format("[{:.5f},{:.5f},{:.5f}]", direction.x(), direction.y(), direction.z());
}

std::string arm_text(const std::string& name, const arm::ArmModel& model, const arm::Joints& joints) {
  std::string points;
  for (const Eigen::Vector3d& point : arm::skeleton(model, joints)) {
    points += (points.empty() ? "" : ",") + point_text(point);
  }
  const arm::ToolPose tool = arm::forward(model, joints);
  return fmt::format("{{\"arm\":{},\"points\":[{}],\"grip\":{},\"approach\":{},\"closing\":{}}}", json_string(name),
                     points, point_text(tool.translation()), direction_text(tool.linear().col(2)),
                     direction_text(tool.linear().col(1)));
}

// Of that arm, if the fact is of an arm that is known here.
std::optional<arm::Joints> joints_in(const Datum& readings, const arm::ArmModel& model) {
  if (readings.size() != model.axes.size()) return std::nullopt;
  arm::Joints joints(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (!readings[i].is_number()) return std::nullopt;
    joints[i] = readings[i].number();
  }
  return joints;
}

// A page that may read this fact may see the stream's images.
Datum fact_of_stream(const std::string& stream) {
  return list("stream"_sym, Datum::symbol(stream), "?kind"_sym, "?place"_sym);
}

// An object that says of which moment it is; as it is where that is now.
std::string of_the_past(std::string object, const std::string& past) {
  return past.empty() ? object : fmt::format("{{\"past\":{},{}", past, object.substr(1));
}

}  // namespace

void Session::heard(const Datum& form) {
  if (!voice_.heard(form[1].integer())) voice_.close(1008, "not understood");
}

Task<void> Session::follow_arms() {
  const Datum pattern = list("arm-joints"_sym, "?robot"_sym, "?joints"_sym);
  const Result<std::unique_ptr<Watch>> watch =
      co_await runtime::watch_when_declared(context_.board, query_for(pattern));
  if (!watch) co_return;
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    co_await voice_.room();
    say_arms(change->added, {});
  }
}

void Session::say_arms(const std::vector<Answer>& answers, const std::string& past) {
  for (const Answer& answer : answers) {
    const Datum& fact = answer.facts.front().datum;
    if (!fact.is_form("arm-joints")) continue;
    const auto known = setup_.cell.arms.find(std::string(fact[1].text()));
    if (known == setup_.cell.arms.end()) continue;
    const std::optional<arm::Joints> joints = joints_in(fact[2], known->second);
    if (joints) voice_.say_fact(of_the_past(arm_text(known->first, known->second, *joints), past));
  }
}

void Session::follow(const Datum& form) {
  const Result<Query> query = query_from_datum(form[2]);
  if (!query) return voice_.say(failed_watch_text(form[1].integer(), query.error()));
  std::erase_if(watches_, [](const auto& entry) { return entry.second.done(); });
  if (watches_.size() >= max_watches || watches_.contains(form[1].integer())) {
    return voice_.say(
        failed_watch_text(form[1].integer(), {"too-many", "too many questions are watched already", {}, {}}));
  }
  watches_.emplace(form[1].integer(), setup_.executor.spawn(start_watch(form[1].integer(), *query, true)));
}

void Session::watch(const Datum& form) {
  const Number number = form[1].integer();
  const Result<Source> source = read_source(form[2].text(), "query", query_limits);
  if (!source) return voice_.say(failed_watch_text(number, source.error()));
  if (source->data().size() != 1) {
    return voice_.say(failed_watch_text(number, {"malformed", "a query is one form, as (on ?x ?y)", {}, {}}));
  }
  Result<Query> query = query_from_datum(source->data().front());
  if (!query) return voice_.say(failed_watch_text(number, query.error()));
  std::erase_if(watches_, [](const auto& entry) { return entry.second.done(); });
  if (watches_.size() >= max_watches || watches_.contains(number)) {
    return voice_.say(failed_watch_text(number, {"too-many", "too many questions are watched already", {}, {}}));
  }
  watches_.emplace(number, setup_.executor.spawn(start_watch(number, std::move(*query), false)));
}

void Session::ask(const Datum& form) {
  const Number number = form[1].integer();
  const Result<Query> query = query_from_datum(form[2]);
  if (!query) return voice_.say(failed_watch_text(number, query.error()));
  begin_request(number, ask_now(number, *query));
}

Task<void> Session::ask_now(Number number, Query query) {
  const Result<Answers> answers = co_await runtime::answers_if_declared(context_.board, std::move(query));
  if (!answers) {
    voice_.say(failed_watch_text(number, answers.error()));
    co_return;
  }
  const Change change{answers->revision, true, answers->answers, {}};
  co_await voice_.room();
  voice_.say_fact(change_text(number, change));
}

void Session::then(const Datum& form) {
  const Number number = form[1].integer();
  const Result<Query> read = query_from_datum(form[2]);
  if (!read) return voice_.refuse(number, read.error().symbol, read.error().sentence);
  Query query = *read;
  query.at = Moment{};
  query.at->time = Time(Duration(std::max<Number>(0, form[3].integer())));
  begin_request(number, ask_then(number, std::move(query)));
}

Task<void> Session::ask_then(Number number, Query query) {
  const std::string past = std::to_string(query.at->time.time_since_epoch().count());
  Result<Answers> answers = co_await context_.board.ask(std::move(query));
  if (!answers) {
    voice_.say(of_the_past(failed_watch_text(number, answers.error()), past));
    co_return;
  }
  const Change change{answers->revision, true, std::move(answers->answers), {}};
  co_await voice_.room();
  voice_.say_fact(of_the_past(change_text(number, change), past));
  say_arms(change.added, past);
}

void Session::picture(const Datum& form) {
  const Number number = form[1].integer();
  if (setup_.pictures == nullptr) return voice_.refuse(number, "no-picture", "this console keeps no pictures");
  begin_request(number, show_kept(number, std::string(form[2].text()), Time(Duration(form[3].integer()))));
}

Task<void> Session::show_kept(Number number, std::string stream, Time moment) {
  const Result<std::vector<Fact>> readable = co_await context_.board.facts(fact_of_stream(stream));
  if (!readable) {
    voice_.say(refusal_text(number, readable.error()));
    co_return;
  }
  const Result<PictureStore::Picture> kept = co_await setup_.pictures->find(std::move(stream), moment);
  if (!kept) {
    voice_.say(refusal_text(number, kept.error()));
    co_return;
  }
  co_await voice_.room();
  std::string message = fmt::format("(picture {} {} {} {} {})\n", number, kept->number,
                                    kept->captured.time_since_epoch().count(), kept->width, kept->height);
  voice_.show(message += kept->jpeg);
}

void Session::unwatch(const Datum& form) { watches_.erase(form[1].integer()); }

Task<void> Session::start_watch(Number number, Query query, bool when_declared) {
  Result<std::unique_ptr<Watch>> watch = fail("unreachable", "not asked yet");
  if (when_declared) {
    watch = co_await runtime::watch_when_declared(context_.board, std::move(query));
  } else {
    watch = co_await context_.board.watch(std::move(query));
  }
  if (!watch) {
    voice_.say(failed_watch_text(number, watch.error()));
    co_return;
  }
  co_await send_changes(number, std::move(*watch));
}

// Changes that a page does not take wait on the board. When too many wait, the board tells the page anew all that
// holds.
Task<void> Session::send_changes(Number number, std::unique_ptr<Watch> watch) {
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

void Session::look(const Datum& form) {
  const std::string stream(form[1].text());
  if (looks_.contains(stream)) return;
  if (looks_.size() >= PageImages::max_streams) return voice_.close(1008, "too many streams");
  looks_.emplace(stream, setup_.executor.spawn(look_if_readable(stream)));
}

// No image comes of a stream whose fact the page's own session may not read.
Task<void> Session::look_if_readable(std::string stream) {
  const Query query = query_for(fact_of_stream(stream));
  const Result<std::unique_ptr<Watch>> readable = co_await runtime::watch_when_declared(context_.board, query);
  if (readable) images_->look(stream);
}

void Session::look_away(const Datum& form) {
  const std::string stream(form[1].text());
  looks_.erase(stream);
  images_->look_away(stream);
}

}  // namespace pizarra::console
