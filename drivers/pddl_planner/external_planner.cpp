#include "drivers/pddl_planner/external_planner.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sys/stat.h>
#include <unistd.h>

namespace pizarra::pddl_planner {

namespace {

namespace fs = std::filesystem;

// A folder for one run, gone with this.
class RunFolder {
 public:
  RunFolder() {
    std::error_code error;
    std::string path = (fs::temp_directory_path(error) / "pizarra-planner-XXXXXX").string();
    if (!error && mkdtemp(path.data()) != nullptr) path_ = path;
  }
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }

  // Empty where none could be made.
  const std::string& path() const { return path_; }
  std::string file(std::string_view name) const { return fmt::format("{}/{}", path_, name); }

 private:
  std::string path_;
};

bool write_file(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  return static_cast<bool>(out.flush());
}

Failure too_much(std::string_view did, std::size_t most_bytes) {
  return {"too-much-output", fmt::format("the planner {} more than {} bytes", did, most_bytes), {}, {}};
}

// Of a plain file; nothing where there is none. What the planner left may be anything: what has no end, or never
// begins, is not read.
Result<std::optional<std::string>> text_of(const std::string& path, std::size_t most_bytes) {
  const int file = open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0 && errno == ENOENT) return std::nullopt;
  struct stat status {};
  const bool plain = file >= 0 && fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  const bool short_enough = plain && static_cast<std::size_t>(status.st_size) <= most_bytes;
  std::string text(short_enough ? static_cast<std::size_t>(status.st_size) : 0, '\0');
  const bool whole = read(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  close(file);
  if (plain && !short_enough) return fail(too_much("wrote a plan of", most_bytes));
  if (!plain || !whole) return fail("garbage", "the file in the place of the planner's plan cannot be read");
  return text;
}

// Planners that go on improving number their plans: the last is the best.
Result<std::optional<std::string>> newest_plan(const std::string& path, std::size_t most_bytes) {
  Result<std::optional<std::string>> newest = text_of(path, most_bytes);
  for (std::size_t i = 1; newest; ++i) {
    Result<std::optional<std::string>> next = text_of(fmt::format("{}.{}", path, i), most_bytes);
    if (next && !*next) break;
    newest = std::move(next);
  }
  return newest;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

// The last line that says something, for a sentence about what went wrong.
std::string last_words(std::string_view output) {
  while (!output.empty()) {
    const std::size_t end = output.find_last_not_of(" \t\r\n");
    if (end == std::string_view::npos) return {};
    output = output.substr(0, end + 1);
    const std::size_t begin = output.find_last_of('\n') + 1;
    std::string line(output.substr(begin, 120));
    // Bytes that are not text are not repeated.
    std::erase_if(line,
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7E; });
    if (!line.empty()) return fmt::format("; it said: {}", line);
    output = output.substr(0, begin);
  }
  return {};
}

// A shell that has another program in its hands tells the signal that ended that as a status; no planner has one of
// these for itself.
std::optional<int> signal_in(int status) {
  constexpr int first = 128;
  return status > first && status < first + NSIG ? std::optional(status - first) : std::nullopt;
}

Failure crashed(int signal, std::string_view output) {
  return {
      "planner-crashed", fmt::format("the planner was ended by {}{}", strsignal(signal), last_words(output)), {}, {}};
}

std::optional<Failure> failure_of_status(const ProcessEnd& end) {
  if (const std::optional<int> signal = signal_in(end.code)) return crashed(*signal, end.output);
  if (end.code == 126 || end.code == 127) {
    return Failure{"planner-missing", "the planner cannot be started" + last_words(end.output), {}, {}};
  }
  if (end.code == 0) return std::nullopt;
  return Failure{"planner-failed",
                 fmt::format("the planner ended with status {} and without a plan{}", end.code, last_words(end.output)),
                 {},
                 {}};
}

std::optional<Failure> failure_of(const ProcessEnd& end, const ProcessLimits& limits) {
  using Kind = ProcessEnd::Kind;
  switch (end.kind) {
    case Kind::exited:
      return failure_of_status(end);
    case Kind::signalled:
      return crashed(end.code, end.output);
    case Kind::timed_out:
      return Failure{"time-out", fmt::format("the planner had no plan after {:g} s", limits.seconds), {}, {}};
    case Kind::cancelled:
      return Failure{"cancelled", "the planner was stopped", {}, {}};
    case Kind::too_much_output:
      return too_much("printed", limits.output_bytes);
    case Kind::not_started:
      return Failure{"planner-missing", "no process can be started", {}, {}};
  }
  return std::nullopt;
}

// The planner's plan, from its file or else from its output; empty where there is no plan to be seen.
Result<std::optional<PlanActions>> plan_left(const std::string& plan_file, const ProcessEnd& end,
                                             const ProcessLimits& limits, const PlanOperators& operators) {
  const Result<std::optional<std::string>> written = newest_plan(plan_file, limits.output_bytes);
  if (!written) return fail(written);
  if (*written) {
    const Result<PlanActions> actions = read_actions(**written, operators);
    if (!actions) return fail(actions);
    return *actions;
  }
  if (end.kind != ProcessEnd::Kind::exited || signal_in(end.code)) return std::nullopt;
  PlanActions found = find_actions(end.output, operators);
  if (found.empty()) return std::nullopt;
  return found;
}

}  // namespace

Result<PlanClaim> ExternalPlanner::plan(const std::string& domain, const std::string& problem,
                                        const PlanOperators& operators, const std::function<bool()>& cancelled) const {
  for (const std::string_view needed : {"{domain}", "{problem}"}) {
    if (command_.find(needed) == std::string::npos) {
      return fail("bad-command",
                  fmt::format("a planner's command has {{domain}} and {{problem}} in it, and {} is missing", needed));
    }
  }
  const RunFolder folder;
  const std::string domain_file = folder.file("domain.pddl");
  const std::string problem_file = folder.file("problem.pddl");
  const std::string plan_file = folder.file("plan");
  if (folder.path().empty() || !write_file(domain_file, domain) || !write_file(problem_file, problem)) {
    return fail("no-folder", "the planner's files do not fit into the folder for temporary files");
  }
  std::string command = replaced(command_, "{domain}", domain_file);
  command = replaced(replaced(command, "{problem}", problem_file), "{plan}", plan_file);
  const ProcessEnd end = run_process(command, folder.path(), limits_, cancelled);

  // One that crashed or ran out of time may have left a plan all the same.
  const std::optional<Failure> ended = failure_of(end, limits_);
  if (end.kind == ProcessEnd::Kind::cancelled) return fail(*ended);
  Result<std::optional<PlanActions>> left = plan_left(plan_file, end, limits_, operators);
  if (left && *left) return PlanClaim{std::move(**left), ended};
  if (ended) return fail(*ended);
  if (!left) return fail(left);
  return fail("garbage", "there is no plan in what the planner wrote" + last_words(end.output));
}

}  // namespace pizarra::pddl_planner
