#include "lisp/forms/arm_names.hpp"

#include <algorithm>
#include <filesystem>

#include "lisp/shipped.hpp"

namespace pizarra::forms {

std::vector<std::string> arm_names() {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(shipped_file("arms"), unreadable)) {
    if (entry.path().extension() == ".scm") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string shipped_arm_file(std::string_view name) { return shipped_file("arms/" + std::string(name) + ".scm"); }

std::string arm_called(std::string_view name) {
  for (const std::string& known : arm_names()) {
    if (known == name || known.ends_with("-" + std::string(name))) return known;
  }
  return "";
}

}  // namespace pizarra::forms
