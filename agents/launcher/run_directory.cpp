#include "agents/launcher/run_directory.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "agents/launcher/process_log.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::launcher {

namespace {

constexpr const char* state_name = "state";
constexpr ReadLimits state_limits{.bytes = 1 << 16, .depth = 4, .elements = 1000};

std::string base_path() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime == '/') return std::string(runtime) + "/pizarra";
  return fmt::format("/tmp/pizarra-{}", getuid());
}

std::string path_of(const std::string& cell, const std::string& host) {
  return fmt::format("{}/{}@{}", base_path(), cell, host);
}

// Makes the folder for this user alone; one that someone else made there is not trusted.
Result<void> make_private(const std::string& path) {
  if (mkdir(path.c_str(), 0700) != 0 && errno != EEXIST) {
    return fail("cannot-write", fmt::format("cannot make {}: {}", path, std::strerror(errno)));
  }
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != getuid() ||
      (status.st_mode & 077) != 0) {
    return fail("cannot-write", fmt::format("{} is not a folder of this user alone", path));
  }
  return {};
}

std::string lock_file(const std::string& path) { return path + "/lock"; }

struct flock whole_file() {
  struct flock out {};
  out.l_type = F_WRLCK;
  out.l_whence = SEEK_SET;
  return out;
}

// Asked without taking the lock, so that who looks never stands in the way of who begins.
bool is_locked(const std::string& path) {
  const int file = open(lock_file(path).c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  struct flock holder = whole_file();
  const bool answered = fcntl(file, F_OFD_GETLK, &holder) == 0;
  close(file);
  return answered && holder.l_type != F_UNLCK;
}

// Nothing where another process has it.
std::shared_ptr<const int> take_lock(const std::string& path) {
  const int file = open(lock_file(path).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return nullptr;
  struct flock wanted = whole_file();
  if (fcntl(file, F_OFD_SETLK, &wanted) != 0) {
    close(file);
    return nullptr;
  }
  return {new int(file), [](const int* held) {
            close(*held);
            delete held;
          }};
}

Result<RunState> load(const std::string& path) {
  std::ifstream in(path);
  if (!in) return fail("nothing-runs", fmt::format("{} cannot be read", path));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const Result<Datum> datum = read_one(text, state_limits, path);
  if (!datum) return fail(datum);
  return run_state_from_datum(*datum);
}

void remove_those(const std::string& path, const std::function<bool(const std::filesystem::path&)>& stale) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    if (stale(entry.path())) std::filesystem::remove(entry.path(), error);
  }
}

// The files that a killed supervisor left in its folder: its state and the sockets, which nobody serves any more. Its
// logs stay, to be read, until the next begins.
void clean(const std::string& path) {
  remove_those(path, [](const auto& file) { return file.filename() == state_name || file.extension() == ".ipc"; });
}

// The sockets stand in the folder, and the system bounds their paths.
Result<void> check_length(const std::string& path) {
  constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
  const std::size_t length = path.size() + std::string_view("/board.ipc").size();
  if (length <= longest) return {};
  return fail("cannot-write",
              fmt::format("{}/board.ipc has {} bytes, and a socket's path at most {}: set XDG_RUNTIME_DIR to a shorter "
                          "folder, or give the cell a shorter name",
                          path, length, longest));
}

}  // namespace

Datum run_state_to_datum(const RunState& state) {
  std::vector<Datum> items{"run"_sym,
                           Datum::string(state.cell),
                           Datum::string(state.host),
                           Datum::integer(state.supervisor_pid),
                           Datum::string(state.board_address),
                           Datum::string(state.world_address),
                           Datum::string(state.key),
                           Datum::string(state.cell_file)};
  for (const RunProcess& process : state.processes) {
    items.push_back(list("process"_sym, process.name, process.pid, process.restarts));
  }
  return Datum::list(std::move(items));
}

Result<RunState> run_state_from_datum(const Datum& datum) {
  if (!datum.is_form("run") || datum.size() < 8) return fail("malformed", "not a run's state", datum);
  RunState state;
  state.cell = datum[1].text();
  state.host = datum[2].text();
  state.supervisor_pid = static_cast<int>(datum[3].integer());
  state.board_address = datum[4].text();
  state.world_address = datum[5].text();
  state.key = datum[6].text();
  state.cell_file = datum[7].text();
  for (const Datum& item : datum.items().subspan(8)) {
    if (!item.is_form("process") || item.size() != 4) return fail("malformed", "not a run's state", item);
    const int pid = static_cast<int>(item[2].integer());
    state.processes.push_back({std::string(item[1].text()), pid, static_cast<int>(item[3].integer())});
  }
  return state;
}

Result<RunDirectory> RunDirectory::make(const std::string& cell, const std::string& host) {
  const std::string path = path_of(cell, host);
  const Result<void> short_enough = check_length(path);
  if (!short_enough) return fail(short_enough);
  const Result<void> made_base = make_private(base_path());
  if (!made_base) return fail(made_base);
  const Result<void> made = make_private(path);
  if (!made) return fail(made);
  std::shared_ptr<const int> lock = take_lock(path);
  if (lock == nullptr) {
    const Result<RunState> earlier = load(path + "/" + state_name);
    const std::string under = earlier ? fmt::format(", under process {}", earlier->supervisor_pid) : "";
    return fail("already-running", fmt::format("the cell {} runs on {} already{}", cell, host, under));
  }
  clean(path);
  remove_those(path, is_process_log);
  return RunDirectory(path, std::move(lock));
}

Result<void> RunDirectory::save(const RunState& state) const {
  const std::string fresh = file("state.new");
  std::ofstream out(fresh, std::ios::trunc);
  out << write(run_state_to_datum(state)) << '\n';
  out.close();
  if (!out || std::rename(fresh.c_str(), file(state_name).c_str()) != 0) {
    return fail("cannot-write", fmt::format("cannot write {}", file(state_name)));
  }
  return {};
}

void RunDirectory::remove_state() const { std::remove(file(state_name).c_str()); }

std::string file_of(const RunState& run, const std::string& name) { return path_of(run.cell, run.host) + "/" + name; }

bool still_runs(const RunState& state) {
  const std::string path = path_of(state.cell, state.host);
  const Result<RunState> now = load(path + "/" + state_name);
  return now && now->supervisor_pid == state.supervisor_pid && is_locked(path);
}

std::vector<RunState> running_cells() {
  std::vector<RunState> out;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(base_path(), error)) {
    Result<RunState> state = load(entry.path().string() + "/" + state_name);
    if (!state) continue;
    if (is_locked(entry.path().string())) {
      out.push_back(std::move(*state));
    } else {
      clean(entry.path().string());
    }
  }
  std::ranges::sort(
      out, [](const RunState& a, const RunState& b) { return std::tie(a.cell, a.host) < std::tie(b.cell, b.host); });
  return out;
}

Result<RunState> find_run(const std::string& cell) {
  std::vector<RunState> runs = running_cells();
  if (!cell.empty()) std::erase_if(runs, [&](const RunState& run) { return run.cell != cell; });
  if (runs.empty()) {
    return fail("nothing-runs", cell.empty() ? std::string("no cell runs here; start one with `up CELL-FILE`")
                                             : fmt::format("no cell named {} runs here", cell));
  }
  if (runs.size() > 1 && runs.front().board_address != runs.back().board_address) {
    return fail("which-cell", "several cells run here: choose one with --cell NAME or --board ADDRESS");
  }
  return runs.front();
}

}  // namespace pizarra::launcher
