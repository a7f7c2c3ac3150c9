#include "agents/launcher/local_cell.hpp"

#include <fmt/format.h>

namespace pizarra::launcher {

struct LocalCell::Running {
  std::unique_ptr<Board> view;
  std::unique_ptr<BuiltAgent> agent;
  Job job;
};

LocalCell::LocalCell(Executor& executor, forms::CellDescription description, std::uint64_t seed)
    : executor_(executor),
      description_(std::move(description)),
      random_(seed),
      board_(executor),
      world_(executor, world_config(description_, seed).value()),
      link_(world_) {}

LocalCell::~LocalCell() = default;

Result<void> LocalCell::start(const std::string& kind, const std::string& host) {
  if (agents_.contains(kind)) return fail("already-running", fmt::format("the {} agent runs already", kind));
  if (const DevicePlugin plugin = plugin_of(kind, description_); !plugin.library.empty()) {
    const std::string sentence =
        fmt::format("the {}'s plug-in has a process of its own: ./pizarra up runs it", plugin.device);
    return fail("no-plugin", sentence, Datum::symbol(kind));
  }
  auto running = std::make_unique<Running>();
  running->view = board_.view(kind);
  runtime::AgentContext context{kind, host, executor_, *running->view, random_.split(kind)};
  Result<std::unique_ptr<BuiltAgent>> built = build_agent(kind, std::move(context), description_, link_, &streams_);
  if (!built) return fail(built);
  running->agent = std::move(*built);
  running->job = executor_.spawn(running->agent->run());
  agents_.emplace(kind, std::move(running));
  return {};
}

Result<void> LocalCell::kill(const std::string& kind) {
  if (agents_.erase(kind) == 0) return fail("not-running", fmt::format("no {} agent runs", kind));
  return {};
}

std::optional<Failure> LocalCell::ended(const std::string& kind) const {
  const auto found = agents_.find(kind);
  const Result<void>* ended = found == agents_.end() ? nullptr : found->second->agent->ended();
  if (ended == nullptr) return std::nullopt;
  return *ended ? Failure{"ended", fmt::format("the {} agent has ended", kind), {}, {}} : ended->error();
}

}  // namespace pizarra::launcher
