#include "lisp/balance.hpp"

#include <algorithm>

#include "lisp/characters.hpp"

namespace pizarra {

namespace {

constexpr std::size_t most_errors = 10;

class Balancer {
 public:
  Balancer(std::string_view text, const DepthOfForm& depth_of_form) : text_(text), depth_of_form_(depth_of_form) {}

  Balanced run() {
    for (at_ = 0; at_ < text_.size(); ++at_) step();
    if (!open_.empty()) complain(open_.back(), "unclosed-list", "this list is not closed");
    while (!open_.empty()) close_here();
    return std::move(out_);
  }

 private:
  void complain(std::size_t offset, std::string symbol, std::string sentence) {
    if (out_.errors.size() == most_errors) return;
    out_.errors.push_back({offset, std::move(symbol), std::move(sentence)});
  }

  void step() {
    const char c = text_[at_];
    if (c == ';' || c == '"') return skip_to_end_of(c);
    if (c == '(') return open();
    if (c == ')') return close();
    out_.text += c;
  }

  // Comments and strings as they are.
  void skip_to_end_of(char begin) {
    const char end = begin == ';' ? '\n' : '"';
    out_.text += text_[at_++];
    while (at_ < text_.size() && text_[at_] != end) {
      if (begin == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) out_.text += text_[at_++];
      out_.text += text_[at_++];
    }
    if (at_ < text_.size()) out_.text += text_[at_];
  }

  std::string_view name_behind() const {
    const std::size_t begin = std::min(text_.find_first_not_of(" \t\r\n", at_ + 1), text_.size());
    std::size_t end = begin;
    while (end < text_.size() && is_symbol_char(text_[end])) ++end;
    return text_.substr(begin, end - begin);
  }

  void open() {
    const std::optional<std::size_t> depth = depth_of_form_(name_behind());
    if (depth && open_.size() > *depth) {
      complain(open_.back(), "unclosed-list", "this list is not closed before the next form begins");
      while (open_.size() > *depth) close_here();
    } else if (depth == 1 && open_.empty() && last_close_) {
      complain(last_close_->offset, "unexpected-close", "this closes the whole form, and more of it follows");
      out_.text[last_close_->in_text] = ' ';
      open_.push_back(last_close_->opened);
    }
    open_.push_back(at_);
    out_.text += '(';
  }

  void close() {
    if (open_.empty()) {
      complain(at_, "unexpected-close", "nothing is open that this could close");
      out_.text += ' ';
      return;
    }
    if (open_.size() == 1) last_close_ = LastClose{at_, out_.text.size(), open_.back()};
    open_.pop_back();
    out_.text += ')';
  }

  void close_here() {
    open_.pop_back();
    out_.inserted.push_back(std::min(at_, text_.size()));
    out_.text += ')';
  }

  struct LastClose {
    std::size_t offset, in_text, opened;
  };

  std::string_view text_;
  const DepthOfForm& depth_of_form_;
  std::size_t at_ = 0;
  std::vector<std::size_t> open_;
  std::optional<LastClose> last_close_;  // of an outermost list
  Balanced out_;
};

}  // namespace

std::size_t Balanced::original_offset(std::size_t offset) const {
  std::size_t low = 0, high = inserted.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (inserted[middle] + middle < offset) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return offset - low;
}

Balanced balance(std::string_view text, const DepthOfForm& depth_of_form) {
  return Balancer(text, depth_of_form).run();
}

}  // namespace pizarra
