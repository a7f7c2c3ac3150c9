#pragma once

// As much of a terminal as the line editor uses: what stands on the screen after what was written to it.
//
//   Screen screen(40);
//   screen.write("pizarra> (ask\b\x1b[K");
//   screen.text();            // "pizarra> (as"
//
// A sequence that is not known shows as text, so that no test passes by overlooking it.

#include <string>
#include <string_view>
#include <vector>

namespace pizarra::repl {

class Screen {
 public:
  explicit Screen(std::size_t columns) : columns_(columns), rows_(1, std::string(columns, ' ')) {}

  void write(std::string_view bytes);
  // The rows, blanks at their ends taken off, and the last ones where nothing stands.
  std::string text() const;

 private:
  void control(char letter, std::size_t count);
  void put(char c);
  void next_row();
  std::string& row() { return rows_[y_]; }

  std::size_t columns_;
  std::vector<std::string> rows_;
  std::size_t x_ = 0;
  std::size_t y_ = 0;
  std::string escape_;  // a sequence that has begun
};

}  // namespace pizarra::repl
