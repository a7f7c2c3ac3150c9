#pragma once

// Where the tree under test lies, for tests that read files of it.
//
//   read_domain_file(source_dir() + "/domains/blocks.scm")

#include <string>

namespace pizarra {

std::string source_dir();

}  // namespace pizarra
