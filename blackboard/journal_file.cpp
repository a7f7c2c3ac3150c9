#include "blackboard/journal_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sys/file.h>
#include <unistd.h>

#include "blackboard/journal.hpp"

namespace pizarra {

namespace {

std::unexpected<Failure> refused(const std::string& what, const std::string& path) {
  return fail("journal-file", what + " " + path + ": " + std::strerror(errno));
}

}  // namespace

Result<std::unique_ptr<JournalFile>> JournalFile::open(const std::string& path, Store& store) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) return refused("cannot open", path);
  std::unique_ptr<JournalFile> journal(new JournalFile(file, path));
  if (flock(file, LOCK_EX | LOCK_NB) != 0) return refused("another board keeps", path);
  const Result<void> replayed = journal->replay_into(store);
  if (!replayed) return fail(replayed);
  return journal;
}

JournalFile::~JournalFile() { close(file_); }

Result<void> JournalFile::replay_into(Store& store) {
  std::ifstream lines(path_, std::ios::binary);
  std::string line;
  off_t whole = 0;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    // The last one without its newline.
    if (lines.eof()) break;
    Result<void> replayed = replay_line(line, store);
    if (!replayed) {
      Failure failure = replayed.error();
      failure.symbol = "bad-journal";
      failure.sentence = path_ + ", line " + std::to_string(number) + ": " + failure.sentence;
      return fail(failure);
    }
    whole += static_cast<off_t>(line.size()) + 1;
  }
  if (ftruncate(file_, whole) != 0) return refused("cannot drop the torn last line of", path_);
  return {};
}

void JournalFile::append(std::string_view line) {
  if (failed_) return;
  std::string text(line);
  text += '\n';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file_, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written > 0) {
      done += static_cast<std::size_t>(written);
      continue;
    }
    failed_ = true;
    if (on_failure) on_failure(refused("cannot write", path_).error());
    return;
  }
}

}  // namespace pizarra
