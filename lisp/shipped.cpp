#include "lisp/shipped.hpp"

#include <filesystem>

namespace pizarra {

namespace {

namespace fs = std::filesystem;

struct Places {
  std::string files;
  std::string modules;
};

bool holds_files(const fs::path& folder) {
  std::error_code none;
  return fs::is_directory(folder / "arms", none) && fs::is_directory(folder / "domains", none);
}

Places installed_at(const fs::path& prefix) {
  return {(prefix / "share/pizarra").lexically_normal().string(),
          (prefix / "lib/pizarra/modules").lexically_normal().string()};
}

Places find_places() {
  std::error_code none;
  const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const char* up : {"..", "../.."}) {
    const Places beside = installed_at(folder / up);
    if (holds_files(beside.files)) return beside;
  }
  if (holds_files(PIZARRA_TREE)) return {PIZARRA_TREE, PIZARRA_TREE_MODULES};
  return installed_at(PIZARRA_PREFIX);
}

const Places& places() {
  static const Places found = find_places();
  return found;
}

}  // namespace

const std::string& shipped_folder() { return places().files; }

const std::string& compiled_modules() { return places().modules; }

std::string shipped_file(std::string_view path) { return shipped_folder() + "/" + std::string(path); }

}  // namespace pizarra
