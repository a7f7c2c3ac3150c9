#include "drivers/camera/loaded_module.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <fmt/format.h>

namespace pizarra::camera {

Result<const void*> symbol_in_module(const std::string& file, const std::string& symbol) {
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  const std::filesystem::path path = program.parent_path() / file;
  void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return fail("no-module", fmt::format("{} cannot be loaded: {}", file, dlerror()));
  const void* const found = dlsym(handle, symbol.c_str());
  if (found == nullptr) return fail("no-module", fmt::format("{} is of another version", path.string()));
  return found;
}

}  // namespace pizarra::camera
