#pragma once

// A file beside the program that alone links what many programs do without. It is loaded when it is first needed, and
// never unloaded: what it makes may live as long as the process.
//
//   static const Result<const void*> found = symbol_in_module("pizarra-opencv.so", "pizarra_opencv_files");
//
// The failure is no-module: the file is not beside the program, or cannot be loaded, or is of another version.

#include <string>

#include "lisp/result.hpp"

namespace pizarra::camera {

Result<const void*> symbol_in_module(const std::string& file, const std::string& symbol);

}  // namespace pizarra::camera
