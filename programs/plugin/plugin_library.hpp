#pragma once

// Loads a plug-in from the folders that are for them.
//
//   Result<PluginLibrary> library = PluginLibrary::load("libmyarm.so", plugin_folders(""));
//   Result<arm::Maker> make = library->symbol("pizarra_make_arm");
//
// A library is its file's name alone, and is looked for in the folders in order. Folder, file and all that lead there
// must belong to root or this user, and nobody else may write to them: whoever can write a plug-in drives the arm.
// Failures: bad-plugin-name, no-plugin, unsafe-plugin, bad-plugin (it cannot be loaded, or is of another ABI).

#include <memory>
#include <string>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::programs {

// The one named, or else those of PIZARRA_PLUGINS, parted by colons, or else the one beside the installed programs.
std::vector<std::string> plugin_folders(const std::string& named);

class PluginLibrary {
 public:
  static Result<PluginLibrary> load(const std::string& name, const std::vector<std::string>& folders);
  Result<void*> symbol(const char* name) const;

 private:
  explicit PluginLibrary(std::string file, std::shared_ptr<void> handle)
      : file_(std::move(file)), handle_(std::move(handle)) {}
  std::string file_;
  std::shared_ptr<void> handle_;
};

}  // namespace pizarra::programs
