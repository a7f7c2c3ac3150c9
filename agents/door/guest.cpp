#include "agents/door/guest.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::door {

namespace {

constexpr ReadLimits line_limits{.bytes = Lines::longest, .depth = 16, .elements = 512};

std::unexpected<Failure> not_understood(std::string sentence) { return fail("malformed", std::move(sentence)); }

Datum datum_of(const Answer& answer) {
  if (answer.facts.size() == 1) return answer.facts.front().datum;
  std::vector<Datum> facts;
  for (const Fact& fact : answer.facts) facts.push_back(fact.datum);
  return Datum::list(std::move(facts));
}

Result<Datum> revision_of(const Result<Revision>& told) {
  if (!told) return fail(told);
  return list(*told);
}

std::unexpected<Failure> too_large(std::size_t size) {
  return fail("too-large",
              fmt::format("the answer has {} characters, and a line {} at most: ask for less", size, Lines::longest));
}

}  // namespace

std::string failure_line(std::string_view word, const Failure& failure) {
  // A sentence may hold what was said.
  constexpr std::size_t longest_sentence = 400;
  std::string line = fmt::format("({} {} ", word, failure.symbol);
  write_to(line, Datum::string(std::string_view(failure.sentence).substr(0, longest_sentence)));
  return line += ')';
}

// What a device may say: `fixed` elements of these kinds, or lists, one at least.
struct Guest::Verb {
  std::string_view name;
  std::vector<Datum::Kind> takes;
  bool many;
  std::string_view usage;
  Task<Result<Datum>> (Guest::*run)(const Datum& form);

  bool fits(const Datum& form) const {
    const std::size_t elements = form.size() - 1;
    if (many) return elements > 0 && std::ranges::all_of(form.items().subspan(1), &Datum::is_list);
    if (elements != takes.size()) return false;
    for (std::size_t i = 0; i < elements; ++i) {
      if (form[i + 1].kind() != takes[i]) return false;
    }
    return true;
  }
  static std::span<const Verb> all();
  static const Verb* find(const Datum& form) {
    const auto found = std::ranges::find(all(), form.head(), &Verb::name);
    return found == all().end() ? nullptr : &*found;
  }
};

std::span<const Guest::Verb> Guest::Verb::all() {
  constexpr auto number = Datum::Kind::integer;
  constexpr auto form = Datum::Kind::list;
  static const std::vector<Verb> verbs = {{"declare", {}, true, "(declare RELATION ...)", &Guest::declare},
                                          {"tell", {}, true, "(tell FACT ...)", &Guest::tell},
                                          {"tell-leased", {}, true, "(tell-leased FACT ...)", &Guest::tell_leased},
                                          {"retract", {}, true, "(retract PATTERN ...)", &Guest::retract},
                                          {"ask", {form}, false, "(ask QUERY)", &Guest::ask},
                                          {"watch", {number, form}, false, "(watch N QUERY)", &Guest::watch},
                                          {"unwatch", {number}, false, "(unwatch N)", &Guest::unwatch},
                                          {"lease", {number}, false, "(lease MILLISECONDS)", &Guest::lease},
                                          {"release", {}, false, "(release)", &Guest::release}};
  return verbs;
}

Task<void> Guest::run(std::optional<Time> deadline) {
  const Result<void> ended = co_await converse(deadline);
  watches_.clear();
  session_.reset();
  if (ended.error().symbol != "disconnected") lines_.say(failure_line("closed", ended.error()));
}

// Until it fails.
Task<Result<void>> Guest::converse(std::optional<Time> deadline) {
  while (true) {
    co_await lines_.room();
    const Result<std::string> line = co_await lines_.next(deadline);
    if (!line) co_return fail(line);
    const Result<Datum> form = read_one(*line, line_limits, "line");
    if (!form) co_return fail(form);
    if (form->is_form("hello")) {
      const Result<void> greeted = greet(*form);
      if (!greeted) co_return fail(greeted);
      deadline.reset();
      continue;
    }
    if (!session_) co_return not_understood("the first line is (hello NAME \"TOKEN\")");
    const Verb* verb = Verb::find(*form);
    if (verb == nullptr) co_return not_understood("a line is (tell FACT ...), or another form of the text door");
    if (!verb->fits(*form)) co_return not_understood(fmt::format("this is not {}", verb->usage));
    const Result<void> answered = co_await answer(*verb, *form);
    if (!answered) co_return fail(answered);
  }
}

Result<void> Guest::greet(const Datum& hello) {
  if (hello.size() != 3 || !hello[1].is_symbol() || !hello[2].is_string()) {
    return not_understood("the first line is (hello NAME \"TOKEN\")");
  }
  Result<Admitted> admitted = admit_(std::string(hello[1].text()), std::string(hello[2].text()));
  if (!admitted) return fail(admitted);
  watches_.clear();
  lease_ = 0;
  session_ = std::move(*admitted);
  lines_.say(fmt::format("(welcome {})", session_->pass.name));
  return {};
}

Task<Result<void>> Guest::answer(const Verb& verb, const Datum& form) {
  Result<Datum> value = co_await (this->*verb.run)(form);
  std::string line = "(ok";
  if (value) {
    for (const Datum& item : value->items()) write_to(line += ' ', item);
    line += ')';
    if (line.size() > Lines::longest) value = too_large(line.size());
  }
  lines_.say(value ? line : failure_line("fail", value.error()));
  // Its changes come behind the answer.
  if (value && verb.name == "watch") {
    const Number number = form[1].integer();
    watches_.at(number).saying = executor_.spawn(say_changes(number));
  }
  co_return Result<void>();
}

Task<Result<Datum>> Guest::declare(const Datum& form) {
  std::vector<Relation> relations;
  for (const Datum& item : form.items().subspan(1)) {
    const Result<void> permitted = session_->pass.may_declare(item);
    if (!permitted) co_return fail(permitted);
    Result<Relation> relation = relation_from_datum(item);
    if (!relation) co_return fail(relation);
    relations.push_back(std::move(*relation));
  }
  const Result<void> declared = co_await session_->board->declare(std::move(relations));
  if (!declared) co_return fail(declared);
  co_return list();
}

Task<Result<Datum>> Guest::tell(const Datum& form) { return tell_under(form, 0); }

Task<Result<Datum>> Guest::tell_leased(const Datum& form) {
  if (lease_ == 0) co_return fail("unknown-lease", "there is no lease yet: (lease MILLISECONDS) takes one");
  co_return co_await tell_under(form, lease_);
}

Task<Result<Datum>> Guest::tell_under(const Datum& form, LeaseId lease) {
  Transaction transaction;
  for (const Datum& fact : form.items().subspan(1)) {
    const Result<void> permitted = session_->pass.may_tell(fact);
    if (!permitted) co_return fail(permitted);
    transaction.tell(fact, {}, lease);
  }
  const Result<Revision> told = co_await session_->board->transact(std::move(transaction));
  co_return revision_of(told);
}

Task<Result<Datum>> Guest::retract(const Datum& form) {
  Transaction transaction;
  for (const Datum& pattern : form.items().subspan(1)) {
    const Result<void> permitted = session_->pass.may_tell(pattern);
    if (!permitted) co_return fail(permitted);
    transaction.retract(pattern);
  }
  const Result<Revision> retracted = co_await session_->board->transact(std::move(transaction));
  co_return revision_of(retracted);
}

Task<Result<Datum>> Guest::ask(const Datum& form) {
  Result<Query> query = query_from_datum(form[1]);
  if (!query) co_return fail(query);
  const Result<void> permitted = session_->pass.may_read(*query);
  if (!permitted) co_return fail(permitted);
  const Result<Answers> answers = co_await session_->board->ask(std::move(*query));
  if (!answers) co_return fail(answers);
  std::vector<Datum> items;
  for (const Answer& answer : answers->answers) items.push_back(datum_of(answer));
  co_return Datum::list(std::move(items));
}

Task<Result<Datum>> Guest::watch(const Datum& form) {
  const Number number = form[1].integer();
  Result<Query> query = query_from_datum(form[2]);
  if (!query) co_return fail(query);
  const Result<void> permitted = session_->pass.may_read(*query);
  if (!permitted) co_return fail(permitted);
  std::erase_if(watches_, [](const auto& entry) { return entry.second.saying.done(); });
  if (watches_.contains(number)) co_return fail("already-there", fmt::format("there is a watch {} already", number));
  if (watches_.size() >= most_watches) {
    co_return fail("too-many", fmt::format("a device has {} watches at most", most_watches));
  }
  Result<std::unique_ptr<Watch>> watch = co_await session_->board->watch(*query);
  if (!watch) co_return fail(watch);
  Watched& watched = watches_[number];
  watched.query = std::move(*query);
  watched.watch = std::move(*watch);
  co_return list();
}

Task<Result<Datum>> Guest::unwatch(const Datum& form) {
  if (watches_.erase(form[1].integer()) == 0) {
    co_return fail("unknown-watch", fmt::format("there is no watch {}", form[1].integer()));
  }
  co_return list();
}

Task<Result<Datum>> Guest::lease(const Datum& form) {
  const Duration length = std::chrono::milliseconds(std::clamp<Number>(form[1].integer(), 0, 1'000'000'000));
  if (length <= Duration::zero() || length > longest_lease) {
    co_return fail("wrong-shape", "a lease has 1 to 3600000 milliseconds");
  }
  if (lease_ != 0 && length == lease_length_) {
    const Result<void> renewed = co_await session_->board->renew(lease_);
    if (renewed) co_return list("kept"_sym);
    if (renewed.error().symbol != "unknown-lease") co_return fail(renewed);
  } else if (lease_ != 0) {
    const Result<void> released = co_await session_->board->release(lease_);
    if (!released && released.error().symbol != "unknown-lease") co_return fail(released);
  }
  lease_ = 0;
  const Result<LeaseId> taken = co_await session_->board->lease(length);
  if (!taken) co_return fail(taken);
  lease_ = *taken;
  lease_length_ = length;
  co_return list("new"_sym);
}

Task<Result<Datum>> Guest::release(const Datum&) {
  if (lease_ == 0) co_return fail("unknown-lease", "there is no lease");
  const Result<void> released = co_await session_->board->release(lease_);
  if (!released) co_return fail(released);
  lease_ = 0;
  co_return list();
}

Task<void> Guest::say_changes(Number number) {
  Watch& watch = *watches_.at(number).watch;
  while (true) {
    const Result<Change> change = co_await watch.next();
    if (!change) {
      const std::string line = failure_line(fmt::format("lost {}", number), change.error());
      co_await say_in_turn(line);
      co_return;
    }
    bool open = true;
    if (change->resynchronised) open = co_await say_in_turn(fmt::format("(anew {})", number));
    if (open) open = co_await say_answers("went", number, change->removed);
    if (open) open = co_await say_answers("came", number, change->added);
    if (open) open = co_await say_in_turn(fmt::format("(now {} {})", number, change->revision));
    if (!open) co_return;
  }
}

Task<bool> Guest::say_answers(std::string_view word, Number number, const std::vector<Answer>& answers) {
  for (const Answer& answer : answers) {
    std::string line = fmt::format("({} {} {})", word, number, write(datum_of(answer)));
    if (line.size() > Lines::longest) {
      line = failure_line(fmt::format("lost {}", number), too_large(line.size()).error());
      co_await say_in_turn(line);
      co_return false;
    }
    const bool open = co_await say_in_turn(std::move(line));
    if (!open) co_return false;
  }
  co_return true;
}

Task<bool> Guest::say_in_turn(std::string line) {
  const bool open = co_await lines_.room();
  if (open) lines_.say(line);
  co_return open;
}

}  // namespace pizarra::door
