#include "tests/programs/taught_cell.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {

std::string taught_cell(const std::string& program) {
  std::string folder = scratch_folder() + "taught/";
  const Said said = shell(fmt::format("{}/tests/taught_cell {} {} 2>&1", source_dir(), program, folder));
  if (said.status != 0) throw std::runtime_error(said.text);
  return folder;
}

}  // namespace pizarra::programs
