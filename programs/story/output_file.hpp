#pragma once

// Files that a run leaves: whether they can be written, and whether they were. A disk may fill meanwhile, and libraries
// do not say so.
//
//   Result<void> writable = check_writable("out/demo.png");     // before a long run
//   Result<void> written = write_file("out/demo.png", bytes);
//   if (!is_whole_film("out/demo.avi")) return fail(unwritten("out/demo.avi"));
//
// Failure: cannot-write, with the path and the system's reason.

#include <cstdint>
#include <span>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::story {

// Makes the folder it is to be in, where there is none.
Result<void> make_folder_of(const std::string& path);
// Leaves what is there as it is.
Result<void> check_writable(const std::string& path);
Result<void> write_file(const std::string& path, std::span<const std::uint8_t> bytes);

// Whether an AVI or MP4 file reaches as far as it says itself, its index included.
bool is_whole_film(const std::string& path);

// The failure of a file that is not whole; finds the reason by trying to write on.
Failure unwritten(const std::string& path);

}  // namespace pizarra::story
