#include "tests/whole_file.hpp"

#include <fstream>
#include <sstream>

namespace pizarra {

std::string whole_file(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace pizarra
