#pragma once

// Whether files are as they were when they were read, told without reading them.
//
//   FileStates states;
//   states.note("circle-1.pgm");                     // before it is read: what is written meanwhile is another state
//   if (!states.unchanged()) ...                     // one of them was written, replaced or removed

#include <filesystem>
#include <map>
#include <optional>

namespace pizarra::vision {

class FileStates {
 public:
  void clear() { noted_.clear(); }
  void note(const std::filesystem::path& file) { noted_.insert_or_assign(file, state_of(file)); }
  bool unchanged() const;

 private:
  struct State {
    std::uint64_t inode;
    std::int64_t size;
    std::int64_t seconds, nanoseconds;  // of its last change, which nothing sets back as it does the time of writing
    bool operator==(const State&) const = default;
  };
  // Nothing where there is no file.
  static std::optional<State> state_of(const std::filesystem::path& file);

  std::map<std::filesystem::path, std::optional<State>> noted_;
};

}  // namespace pizarra::vision
