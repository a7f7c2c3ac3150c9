#pragma once

// Files that come with the programs: arms, domains, examples, Scheme modules. An installed program finds them beside
// where it stands, wherever that was moved to; one of a build folder in the tree that it was built from.
//
//   std::string arm = shipped_file("arms/crs-f3.scm");

#include <string>
#include <string_view>

namespace pizarra {

// The folder that holds them: PREFIX/share/pizarra of a program in PREFIX/lib/pizarra or PREFIX/bin, or else the tree,
// or else where the libraries were installed.
const std::string& shipped_folder();
// Where the compiled Scheme modules are.
const std::string& compiled_modules();
std::string shipped_file(std::string_view path);

}  // namespace pizarra
