#pragma once

// A journal kept in a file that only grows, for a board that is to live again.
//
//   Store store;
//   Result<std::unique_ptr<JournalFile>> file = JournalFile::open("cell.journal", store);   // replays what is there
//   board.set_journal([&](std::string_view line) { (*file)->append(line); });
//
// A last line that a crash tore off is dropped; any other that cannot be replayed is a failure. One process at a time
// has the file. A line is handed to the operating system before append() returns: it survives the process, and what
// survives a power cut is the file system's promise.

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "blackboard/store.hpp"

namespace pizarra {

class JournalFile {
 public:
  // Failures bad-journal, and journal-file for what the operating system refuses.
  static Result<std::unique_ptr<JournalFile>> open(const std::string& path, Store& store);
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;
  ~JournalFile();

  // After the first line that could not be written, nothing more is, and `on_failure` is called once.
  void append(std::string_view line);
  std::function<void(const Failure&)> on_failure;

 private:
  JournalFile(int file, std::string path) : file_(file), path_(std::move(path)) {}
  Result<void> replay_into(Store& store);

  const int file_;
  const std::string path_;
  bool failed_ = false;
};

}  // namespace pizarra
