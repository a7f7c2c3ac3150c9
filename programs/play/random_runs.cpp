#include "programs/play/random_runs.hpp"

#include <fmt/format.h>
#include <map>

#include "lisp/json.hpp"
#include "programs/command_line/exit_codes.hpp"
#include "programs/story/random_run.hpp"
#include "programs/story/seed_pool.hpp"

namespace pizarra::programs {

namespace {

using Kind = story::RandomResult::Kind;

std::string text_of(const story::RandomResult& result) {
  return fmt::format("{}{}", static_cast<int>(result.kind), result.line);
}

story::RandomResult result_in(const story::SeedPool::Answer& answer) {
  if (answer.overdue) return {Kind::timed_out, answer.trouble};
  if (!answer.trouble.empty()) return {Kind::failed, answer.trouble};
  return {static_cast<Kind>(answer.text.front() - '0'), answer.text.substr(1)};
}

class Report {
 public:
  explicit Report(const RandomRuns& runs) : runs_(runs) {}
  // False: the cell cannot be read, and no seed can be run.
  bool hear(std::uint64_t seed, const story::RandomResult& result);
  void print_summary(bool interrupted);
  const std::string& unreadable() const { return unreadable_; }
  int exit_status() const;

 private:
  int count_of(Kind kind) const { return counts_.contains(kind) ? counts_.at(kind) : 0; }

  const RandomRuns& runs_;
  std::uint64_t done_ = 0;
  std::map<Kind, int> counts_;
  std::string unreadable_;
};

bool Report::hear(std::uint64_t seed, const story::RandomResult& result) {
  static constexpr const char* words[] = {"reached", "refused", "failed", "timed out"};
  if (result.kind == Kind::unreadable) {
    unreadable_ = result.line;
    return false;
  }
  ++counts_[result.kind];
  ++done_;
  const char* word = words[static_cast<int>(result.kind)];
  if (runs_.json) {
    fmt::print("{{\"seed\":{},\"result\":\"{}\",\"line\":{}}}\n", seed, word, json_string(result.line));
  } else {
    fmt::print("seed {:5}  {:<7}  {}\n", seed, word, result.line);
  }
  std::fflush(stdout);
  return true;
}

// On standard error where the lines were not read any more.
void Report::print_summary(bool interrupted) {
  const int timed_out = count_of(Kind::timed_out);
  std::FILE* const out = std::ferror(stdout) == 0 ? stdout : stderr;
  if (runs_.json) {
    fmt::print(out, "{{\"reached\":{},\"refused_correctly\":{},\"failed\":{},\"timed_out\":{}{}}}\n",
               count_of(Kind::reached), count_of(Kind::refused), count_of(Kind::failed), timed_out,
               interrupted ? fmt::format(",\"interrupted_after\":{}", done_) : "");
  } else {
    fmt::print(out, "reached {}, refused correctly {}, failed {}{}{}\n", count_of(Kind::reached),
               count_of(Kind::refused), count_of(Kind::failed),
               timed_out > 0 ? fmt::format(", timed out {}", timed_out) : "",
               interrupted ? fmt::format("; interrupted after {} of {} seeds", done_, runs_.seeds) : "");
  }
}

int Report::exit_status() const {
  if (count_of(Kind::failed) > 0) return exit_failed;
  return count_of(Kind::timed_out) > 0 ? exit_unavailable : exit_reached;
}

int complain_of(const std::string& what, int status) {
  fmt::print(stderr, "pizarra: {}\n", what);
  return status;
}

}  // namespace

int run_random(const RandomRuns& runs) {
  using story::SeedPool;
  SeedPool pool({.first = runs.first_seed, .seeds = runs.seeds, .jobs = runs.jobs, .longest = runs.longest_run},
                [&](std::uint64_t seed) { return text_of(story::run_random_seed(runs.cell_file, runs.arm, seed)); });
  Report report(runs);
  const SeedPool::End end = pool.run(
      [&](std::uint64_t seed, const SeedPool::Answer& answer) { return report.hear(seed, result_in(answer)); });
  if (end == SeedPool::End::no_process) return complain_of("cannot start another process", exit_unavailable);
  if (!report.unreadable().empty()) return complain_of(report.unreadable(), exit_usage);
  report.print_summary(end == SeedPool::End::interrupted);
  return end == SeedPool::End::interrupted ? exit_interrupted : report.exit_status();
}

}  // namespace pizarra::programs
