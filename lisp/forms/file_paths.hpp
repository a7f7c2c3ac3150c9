#pragma once

// A file that another file names.
//
//   beside("cells/blocks.scm", "objects");      // "cells/objects"

#include <filesystem>
#include <string>

namespace pizarra::forms {

// `name` as seen from the folder of `file`: "a/cell.scm" and "../b.scm" give "b.scm". An absolute or empty name stays.
inline std::string beside(const std::string& file, const std::string& name) {
  if (name.empty()) return name;
  return (std::filesystem::path(file).parent_path() / name).lexically_normal().string();
}

}  // namespace pizarra::forms
