#include "programs/emulate/bystander.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

Bystander::Bystander(Executor& executor, BesideDevice device)
    : executor_(executor), device_(std::move(device)), lines_(executor, most_lines), acting_(executor.spawn(act())) {
  executor_.watch_readable(STDIN_FILENO, [this] { hear(); });
}

Bystander::~Bystander() { executor_.unwatch_readable(STDIN_FILENO); }

void Bystander::hear() {
  char chunk[256];
  const ssize_t count = ::read(STDIN_FILENO, chunk, sizeof chunk);
  if (count <= 0) return executor_.unwatch_readable(STDIN_FILENO);
  heard_.append(chunk, static_cast<std::size_t>(count));
  for (std::size_t end = heard_.find('\n'); end != std::string::npos; end = heard_.find('\n')) {
    // Input that is typed faster than the device answers is lost.
    if (end > 0) lines_.push(heard_.substr(0, end));
    heard_.erase(0, end + 1);
  }
  if (heard_.size() > longest_line) heard_.clear();
}

Task<void> Bystander::act() {
  while (true) {
    const std::optional<std::string> line = co_await lines_.pop();
    const Result<void> obeyed = *line == "status" ? Result<void>() : device_.obey(*line);
    if (!obeyed) {
      complain(obeyed.error(), exit_usage);
      continue;
    }
    const std::string status = co_await device_.status();
    fmt::print("{}\n", status);
    std::fflush(stdout);
  }
}

}  // namespace pizarra::programs
