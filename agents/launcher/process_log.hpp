#pragma once

// What a supervised process prints: a file each in the run's folder, appended to by each of its lives, until the next
// run begins.
//
//   const std::string log = directory.file(process_log_name("vision"));      // .../vision.log
//   Result<int> file = open_process_log(log);                                // the caller closes it
//   last_line_of_log(log);                                                   // its last words

#include <filesystem>
#include <string>

#include "lisp/result.hpp"

namespace pizarra::launcher {

std::string process_log_name(const std::string& process);
bool is_process_log(const std::filesystem::path& file);
// For appending, by its owner alone; programs that are started do not inherit it. Failure cannot-start.
Result<int> open_process_log(const std::string& path);
// Empty where there is none.
std::string last_line_of_log(const std::string& path);

}  // namespace pizarra::launcher
