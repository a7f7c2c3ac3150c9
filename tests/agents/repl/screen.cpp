#include "tests/agents/repl/screen.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

namespace pizarra::repl {

void Screen::write(std::string_view bytes) {
  for (const char c : bytes) {
    if (!escape_.empty()) {
      escape_ += c;
      if (c == '[' || c == '?' || std::isdigit(static_cast<unsigned char>(c)) != 0) continue;
      const std::string sequence = std::exchange(escape_, "");
      const bool known = sequence.size() >= 3 && sequence[1] == '[' && sequence[2] != '?';
      const int count = known ? std::atoi(sequence.c_str() + 2) : 0;
      if (known) {
        control(c, static_cast<std::size_t>(count));
      } else {
        for (const char letter : sequence) put(letter);
      }
    } else if (c == '\033') {
      escape_ = c;
    } else if (c == '\r') {
      x_ = 0;
    } else if (c == '\n') {
      next_row();
    } else if (c == '\b') {
      x_ -= std::min<std::size_t>(x_, 1);
    } else if (c != '\a') {
      put(c);
    }
  }
}

void Screen::control(char letter, std::size_t count) {
  const std::size_t steps = std::max<std::size_t>(count, 1);
  x_ = std::min(x_, columns_ - 1);
  switch (letter) {
    case 'A':
      y_ -= std::min(y_, steps);
      break;
    case 'B':
      y_ = std::min(y_ + steps, rows_.size() - 1);
      break;
    case 'C':
      x_ = std::min(x_ + steps, columns_ - 1);
      break;
    case 'D':
      x_ -= std::min(x_, steps);
      break;
    case 'G':
      x_ = std::min(steps, columns_) - 1;
      break;
    case '@':
      row().insert(x_, steps, ' ');
      row().resize(columns_);
      break;
    case 'P':
      row().erase(x_, steps);
      row().resize(columns_, ' ');
      break;
    case 'J':
      rows_.resize(y_ + 1);
      [[fallthrough]];
    case 'K':
      row().replace(x_, columns_ - x_, columns_ - x_, ' ');
      break;
    default:
      put('?');
      put(letter);
  }
}

void Screen::put(char c) {
  if (x_ == columns_) {
    x_ = 0;
    next_row();
  }
  row()[x_++] = c;
}

void Screen::next_row() {
  if (++y_ == rows_.size()) rows_.emplace_back(columns_, ' ');
}

std::string Screen::text() const {
  std::string out;
  for (const std::string& row : rows_) out += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
  out.resize(out.find_last_not_of('\n') + 1);
  return out;
}

}  // namespace pizarra::repl
