#include "programs/plugin/plugin_library.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include "drivers/plugin/plugin.hpp"
#include "lisp/outside_text.hpp"

namespace pizarra::programs {

namespace {

namespace fs = std::filesystem;

// In a folder with the sticky bit, such as /tmp, nobody replaces what is another's.
bool others_may_write(const struct stat& found, bool above) {
  const bool owned = found.st_uid == 0 || found.st_uid == geteuid();
  const bool shared = (found.st_mode & (S_IWGRP | S_IWOTH)) != 0;
  const bool sticky = above && S_ISDIR(found.st_mode) && (found.st_mode & S_ISVTX) != 0;
  return !owned || (shared && !sticky);
}

Result<void> check_safe(const fs::path& file) {
  const fs::path folder = file.parent_path();
  for (fs::path part = file;; part = part.parent_path()) {
    struct stat found {};
    if (stat(part.c_str(), &found) != 0) return fail("no-plugin", fmt::format("cannot look at {}", part.string()));
    const bool above = part != file && part != folder;
    if (others_may_write(found, above)) {
      return fail("unsafe-plugin",
                  fmt::format("{} belongs to another user, or others may write to it: no plug-in is loaded from there",
                              text_of_bytes(part.string())),
                  Datum::string(file.string()));
    }
    if (part == part.root_path()) return {};
  }
}

}  // namespace

std::vector<std::string> plugin_folders(const std::string& named) {
  if (!named.empty()) return {named};
  std::vector<std::string> folders;
  if (const char* configured = std::getenv("PIZARRA_PLUGINS")) {
    std::string rest = configured;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(':'), rest.size());
      if (end > 0) folders.push_back(rest.substr(0, end));
      rest.erase(0, end + 1);
    }
    return folders;
  }
  std::error_code none;
  return {(fs::read_symlink("/proc/self/exe", none).parent_path() / "plugins").string()};
}

Result<PluginLibrary> PluginLibrary::load(const std::string& name, const std::vector<std::string>& folders) {
  if (name.empty() || name.find('/') != std::string::npos || name.front() == '.') {
    return fail("bad-plugin-name", "a plug-in is named by its file's name alone, such as libmyarm.so",
                Datum::string(name));
  }
  for (const std::string& folder : folders) {
    std::error_code none;
    const fs::path file = fs::canonical(fs::path(folder) / name, none);
    if (none) continue;
    const Result<void> safe = check_safe(file);
    if (!safe) return fail(safe);
    void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) return fail("bad-plugin", fmt::format("cannot load it: {}", dlerror()), Datum::string(name));
    // Never unloaded: what it made may live as long as the process.
    PluginLibrary library(file.string(), std::shared_ptr<void>(handle, [](void*) {}));
    const Result<void*> number = library.symbol("pizarra_plugin_abi");
    if (!number) return fail(number);
    const int abi = *static_cast<const int*>(*number);
    if (abi == plugin::abi) return library;
    return fail("bad-plugin", fmt::format("{} was built for plug-ins of the ABI {}, and this is {}: build it again",
                                          name, abi, plugin::abi));
  }
  return fail("no-plugin", fmt::format("there is no plug-in {} in {}; PIZARRA_PLUGINS names the folders",
                                       text_of_bytes(name), fmt::join(folders, ", ")));
}

Result<void*> PluginLibrary::symbol(const char* name) const {
  void* const found = dlsym(handle_.get(), name);
  if (found != nullptr) return found;
  return fail("bad-plugin", fmt::format("{} has no {}: it is not a plug-in of this kind", text_of_bytes(file_), name));
}

}  // namespace pizarra::programs
