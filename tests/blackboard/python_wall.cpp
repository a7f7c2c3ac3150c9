#include "tests/blackboard/python_wall.hpp"

#include <array>
#include <fcntl.h>
#include <spawn.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

#include "blackboard/time/latch.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/writer.hpp"
#include "tests/source_dir.hpp"

namespace pizarra {

namespace {

Result<Answer> answer_from(const Datum& form) {
  Answer answer;
  for (const Datum& fact : form[0].items()) {
    Result<Fact> read = wire::fact_from_datum(fact);
    if (!read) return fail(read);
    answer.facts.push_back(std::move(*read));
  }
  for (const Datum& bound : form[1].items()) answer.bindings.bind(bound[0].text(), bound[1]);
  return answer;
}

Result<std::vector<Answer>> answers_from(std::span<const Datum> forms) {
  std::vector<Answer> answers;
  for (const Datum& form : forms) {
    Result<Answer> answer = answer_from(form);
    if (!answer) return fail(answer);
    answers.push_back(std::move(*answer));
  }
  return answers;
}

Result<Change> change_from(const Datum& form) {
  const Result<std::vector<Answer>> added = answers_from(form[2].items());
  const Result<std::vector<Answer>> removed = answers_from(form[3].items());
  if (!added) return fail(added);
  if (!removed) return fail(removed);
  return Change{wire::count_from(form[0]).value_or(0), form[1].is_symbol("yes"), *added, *removed};
}

Result<std::uint64_t> count_from(const Result<Datum>& reply) {
  if (!reply) return fail(reply);
  return wire::count_from(*reply).value();
}

class PythonWatch : public Watch {
 public:
  PythonWatch(PythonProcess& python, std::int64_t view, std::int64_t number)
      : python_(python), view_(view), number_(number), answered_(python.executor()) {}
  PythonWatch(const PythonWatch&) = delete;
  PythonWatch& operator=(const PythonWatch&) = delete;
  ~PythonWatch() override {
    if (asked_ != 0) python_.forget(asked_);
    python_.begin(view_, list("unwatch"_sym, number_), {});
  }

  // The item for an abandoned wait goes to the next one.
  Task<Result<Change>> next() override {
    if (asked_ == 0) {
      asked_ = python_.begin(view_, list("next"_sym, number_), [this](Result<Datum> reply) {
        reply_ = std::move(reply);
        answered_.wake_all();
      });
    }
    while (!reply_) {
      co_await answered_.wait();
    }
    const Result<Datum> reply = std::move(*reply_);
    reply_.reset();
    asked_ = 0;
    if (!reply) co_return fail(reply);
    co_return change_from(*reply);
  }

 private:
  PythonProcess& python_;
  const std::int64_t view_;
  const std::int64_t number_;
  std::int64_t asked_ = 0;
  std::optional<Result<Datum>> reply_;
  WaitList answered_;
};

class PythonBoard : public Board {
 public:
  PythonBoard(PythonProcess& python, const std::string& address, const std::string& teller, Duration timeout)
      : python_(python), number_(python.next_number()) {
    python_.begin(number_, list("open"_sym, address, teller, static_cast<double>(timeout.count()) / 1e6), {});
  }
  PythonBoard(const PythonBoard&) = delete;
  PythonBoard& operator=(const PythonBoard&) = delete;
  ~PythonBoard() override { python_.begin(number_, list("close"_sym), {}); }

  Task<Result<void>> declare(std::vector<Relation> relations) override {
    std::vector<Datum> operation = {"declare"_sym};
    for (const Relation& relation : relations) operation.push_back(relation_to_datum(relation));
    Datum whole = Datum::list(std::move(operation));
    const Result<Datum> reply = co_await python_.call(number_, std::move(whole));
    if (!reply) co_return fail(reply);
    co_return Result<void>();
  }
  Task<Result<Revision>> transact(Transaction transaction) override {
    std::string text;
    wire::write_transaction(text, transaction);
    // The board says how much is too much.
    constexpr ReadLimits any = {.bytes = 1 << 26, .depth = 1 << 10, .elements = 1 << 24};
    Datum operation = read_one(text, any).value();
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    co_return count_from(reply);
  }
  Task<Result<Answers>> ask(Query query) override {
    Datum operation = list("ask"_sym, query_to_datum(query));
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    if (!reply) co_return fail(reply);
    Result<std::vector<Answer>> answers = answers_from(reply->items().subspan(1));
    if (!answers) co_return fail(answers);
    Answers all;
    all.revision = wire::count_at(*reply, 0).value();
    all.answers = std::move(*answers);
    co_return all;
  }
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override {
    const std::int64_t watch = python_.next_number();
    Datum operation = list("watch"_sym, query_to_datum(query), watch);
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    if (!reply) co_return fail(reply);
    co_return std::make_unique<PythonWatch>(python_, number_, watch);
  }
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override {
    Datum operation = list("take"_sym, pattern, holder);
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    if (!reply) co_return fail(reply);
    if (reply->size() == 0) co_return std::optional<Fact>();
    Result<Fact> fact = wire::fact_from_datum((*reply)[0]);
    if (!fact) co_return fail(fact);
    co_return std::optional<Fact>(std::move(*fact));
  }
  Task<Result<LeaseId>> lease(Duration length) override {
    Datum operation = list("lease"_sym, length.count());
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    co_return count_from(reply);
  }
  Task<Result<void>> renew(LeaseId lease) override { return nothing(list("renew"_sym, lease)); }
  Task<Result<void>> release(LeaseId lease) override { return nothing(list("release"_sym, lease)); }

 private:
  Task<Result<void>> nothing(Datum operation) {
    const Result<Datum> reply = co_await python_.call(number_, std::move(operation));
    if (!reply) co_return fail(reply);
    co_return Result<void>();
  }

  PythonProcess& python_;
  const std::int64_t number_;
};

}  // namespace

PythonProcess::PythonProcess(Executor& executor, Kind kind) : executor_(executor) {
  int to[2];
  int from[2];
  if (pipe2(to, O_CLOEXEC) != 0 || pipe2(from, O_CLOEXEC) != 0) throw std::runtime_error("no pipes");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, to[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, from[1], STDOUT_FILENO);
  // Debian's own, whose packages are there; another one may come first on the path.
  std::string python = "/usr/bin/python3";
  std::string script = source_dir() + "/tests/blackboard/python_wall.py";
  std::string path = "PYTHONPATH=" + source_dir() + "/blackboard/python";
  std::string no_files = "PYTHONDONTWRITEBYTECODE=1";
  std::string utf8 = "PYTHONUTF8=1";
  std::string way = kind == Kind::plain ? "plain" : "asyncio";
  std::array<char*, 4> arguments = {python.data(), script.data(), way.data(), nullptr};
  std::array<char*, 4> environment = {path.data(), no_files.data(), utf8.data(), nullptr};
  const int failed = posix_spawn(&child_, python.c_str(), &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  close(to[0]);
  close(from[1]);
  to_child_ = to[1];
  from_child_ = from[0];
  if (failed != 0) throw std::runtime_error("no python3");
  executor_.watch_readable(from_child_, [this] { receive(); });
}

PythonProcess::~PythonProcess() {
  executor_.unwatch_readable(from_child_);
  close(to_child_);
  close(from_child_);
  waitpid(child_, nullptr, 0);
}

std::unique_ptr<Board> PythonProcess::view(const std::string& address, const std::string& teller, Duration timeout) {
  return std::make_unique<PythonBoard>(*this, address, teller, timeout);
}

std::int64_t PythonProcess::begin(std::int64_t view, const Datum& operation, Done done) {
  const std::int64_t request = next_number();
  std::vector<Datum> whole = {to_datum(request), to_datum(view)};
  whole.insert(whole.end(), operation.items().begin(), operation.items().end());
  if (done) pending_[request] = std::move(done);
  say(write(Datum::list(std::move(whole))) + "\n");
  return request;
}

Task<Result<Datum>> PythonProcess::call(std::int64_t view, Datum operation) {
  std::optional<Result<Datum>> reply;
  Event answered(executor_);
  const std::int64_t request = begin(view, operation, [&](Result<Datum> result) {
    reply = std::move(result);
    answered.set();
  });
  struct Registration {
    PythonProcess& python;
    std::int64_t request;
    ~Registration() { python.forget(request); }
  };
  const Registration registration{*this, request};
  co_await answered.wait();
  co_return std::move(*reply);
}

void PythonProcess::say(const std::string& line) const {
  for (std::size_t said = 0; said < line.size();) {
    const ssize_t more = ::write(to_child_, line.data() + said, line.size() - said);
    if (more <= 0) throw std::runtime_error("python3 is gone");
    said += static_cast<std::size_t>(more);
  }
}

void PythonProcess::receive() {
  std::array<char, 1 << 16> chunk{};
  const ssize_t size = ::read(from_child_, chunk.data(), chunk.size());
  if (size <= 0) throw std::runtime_error("python3 ended");
  unread_.append(chunk.data(), static_cast<std::size_t>(size));
  ReadLimits allowed;
  allowed.bytes = 1 << 26;
  allowed.elements = 1 << 24;
  for (std::size_t end = unread_.find('\n'); end != std::string::npos; end = unread_.find('\n')) {
    const Result<Datum> said = read_one(unread_.substr(0, end), allowed);
    unread_.erase(0, end + 1);
    const auto found = pending_.find(said.value()[0].integer());
    if (found == pending_.end()) continue;
    const Done done = std::move(found->second);
    pending_.erase(found);
    const Datum& outcome = (*said)[1];
    if (outcome.is_form("ok")) {
      done(outcome[1]);
    } else {
      done(fail(failure_from_datum(outcome)));
    }
  }
}

}  // namespace pizarra
