#pragma once

// A file that is read again whenever it was saved.
//
//   ProgramFile file("conveyor.scm");
//   std::optional<Result<std::string>> text = file.look();     // the text; nothing while the file is as it was

#include <optional>
#include <string>
#include <sys/stat.h>

#include "lisp/result.hpp"

namespace pizarra::scheme {

class ProgramFile {
 public:
  explicit ProgramFile(std::string path) : path_(std::move(path)) {}
  // Its text when it was saved since the last look, or why it cannot be read, once.
  std::optional<Result<std::string>> look();
  // The name without its folder.
  std::string name() const;

 private:
  struct Stamp {
    ino_t file = 0;
    off_t size = -1;
    std::int64_t second = 0;
    std::int64_t nanosecond = 0;
    bool operator==(const Stamp&) const = default;
  };
  Stamp stamp() const;

  std::string path_;
  std::optional<Stamp> seen_;
};

}  // namespace pizarra::scheme
