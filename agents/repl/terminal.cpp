#include "agents/repl/terminal.hpp"

#include <algorithm>
#include <cassert>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <editline/readline.h>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "lisp/reader.hpp"

namespace pizarra::repl {

namespace fs = std::filesystem;

namespace {

constexpr int history_lines = 1000;

// The line editor calls plain functions.
Terminal* current = nullptr;

fs::path history_file() {
  if (const char* state = std::getenv("XDG_STATE_HOME")) return fs::path(state) / "pizarra" / "history";
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : "/tmp") / ".local" / "state" / "pizarra" / "history";
}

// The editor frees what it is given.
char* next_completion(const char* text, int state) {
  static std::set<std::string>::const_iterator next;
  const std::set<std::string>& words = current->words();
  if (state == 0) next = words.lower_bound(text);
  if (next == words.end() || !next->starts_with(text)) return nullptr;
  return strdup((next++)->c_str());
}

// Rows and columns below and right of where the prompt begins, after so many bytes of what was typed.
struct Spot {
  int row;
  int column;
};

Spot spot_after(std::string_view prompt, int bytes) {
  int rows = 0;
  int width = 0;
  rl_get_screen_size(&rows, &width);
  const std::string_view typed(rl_line_buffer != nullptr ? rl_line_buffer : "", static_cast<std::size_t>(bytes));
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  const auto at = static_cast<int>(prompt.size()) + static_cast<int>(std::ranges::count_if(typed, begins_character));
  return {at / std::max(width, 1), at % std::max(width, 1)};
}

}  // namespace

bool is_complete(std::string_view text) {
  const Result<std::vector<Datum>> read = read_all(text);
  return read || !read.error().symbol.starts_with("unclosed-");
}

Terminal::Terminal(Executor& executor, std::string prompt)
    : executor_(executor), prompt_(std::move(prompt)), interactive_(isatty(STDIN_FILENO) != 0), lines_(executor, 1) {
  current = this;
  if (interactive_) {
    std::setlocale(LC_CTYPE, "C.UTF-8");  // what the language is written in
    signals_.emplace(std::vector<int>{SIGINT, SIGTERM, SIGHUP, SIGCONT});
    executor_.watch_readable(signals_->file(), [this] {
      for (const int signal : signals_->take()) on_signal(signal);
    });
    std::error_code no_history;
    fs::create_directories(history_file().parent_path(), no_history);
    using_history();
    stifle_history(history_lines);
    read_history(history_file().c_str());
    rl_attempted_completion_function = complete;
    rl_completer_word_break_characters = const_cast<char*>(" ()\"\n");
  }
}

Terminal::~Terminal() {
  stop_listening();
  hide_prompt();
  if (signals_) executor_.unwatch_readable(signals_->file());
  current = nullptr;
}

char** Terminal::complete(const char* text, int, int) {
  if (current == nullptr || !current->words) return nullptr;
  return rl_completion_matches(text, next_completion);
}

void Terminal::line_typed(char* line) {
  if (current == nullptr) return;
  current->prompting_ = false;
  current->stop_listening();
  rl_callback_handler_remove();
  if (line == nullptr) {
    current->take_line(std::nullopt);
    return;
  }
  if (*line != '\0') {
    add_history(line);
    // At once, because a program that is killed writes nothing.
    write_history(history_file().c_str());
  }
  current->take_line(std::string(line) + "\n");
  std::free(line);
}

void Terminal::take_line(std::optional<std::string> line) {
  if (!line) ended_ = true;
  [[maybe_unused]] const bool queued = lines_.push(std::move(line));
  assert(queued && "input is read only when asked for");
}

std::string_view Terminal::prompt() const { return partial_.empty() ? std::string_view(prompt_) : "     ... "; }

void Terminal::show_prompt() {
  if (!interactive_ || prompting_) return;
  prompting_ = true;
  rl_callback_handler_install(std::string(prompt()).c_str(), line_typed);
  // Until a key is pressed the editor's variables tell of the line before.
  rl_point = rl_end = 0;
}

void Terminal::hide_prompt() {
  if (!prompting_) return;
  erase_line();
  prompting_ = false;
  rl_callback_handler_remove();
}

// However many rows it takes.
void Terminal::erase_line() {
  const int row = spot_after(prompt(), rl_point).row;
  if (row > 0) fmt::print("\033[{}A", row);
  fmt::print("\r\033[J");
  std::fflush(stdout);
}

void Terminal::drop_line() {
  const Spot end = spot_after(prompt(), rl_end);
  const int down = end.row - spot_after(prompt(), rl_point).row;
  if (down > 0) fmt::print("\033[{}B", down);
  fmt::print("\r{}^C\n", end.column > 0 ? fmt::format("\033[{}C", end.column) : "");
  std::fflush(stdout);
  rl_callback_handler_remove();
  prompting_ = false;
  partial_.clear();
  show_prompt();
}

void Terminal::on_signal(int signal) {
  const bool typed = prompting_ && (rl_end > 0 || !partial_.empty());
  if (signal == SIGCONT) {
    // Whoever stopped us had the terminal meanwhile.
    if (!prompting_) return;
    rl_callback_handler_remove();
    prompting_ = false;
    show_prompt();
  } else if (signal == SIGINT && typed) {
    drop_line();
  } else if (signal == SIGINT && !prompting_) {
    if (on_interrupt) on_interrupt();
  } else {
    interrupted_ = true;
    ended_ = true;
    if (on_interrupt) on_interrupt();
    if (!prompting_) return;
    hide_prompt();
    stop_listening();
    partial_.clear();
    take_line(std::nullopt);
  }
}

// Only while a line is asked for: input that nobody reads would wake the executor again and again.
void Terminal::listen() {
  show_prompt();
  executor_.watch_readable(STDIN_FILENO, [this] {
    if (interactive_) {
      rl_point = rl_end = 0;  // which the editor leaves as they are when the last letter goes
      rl_callback_read_char();
    } else {
      read_plainly();
    }
  });
}

void Terminal::stop_listening() { executor_.unwatch_readable(STDIN_FILENO); }

void Terminal::read_plainly() {
  stop_listening();
  char buffer[4096];
  const ssize_t got = ::read(STDIN_FILENO, buffer, sizeof buffer);
  if (got > 0) {
    take_line(std::string(buffer, static_cast<std::size_t>(got)));
  } else {
    take_line(std::nullopt);
  }
}

Task<std::optional<std::string>> Terminal::read() {
  while (!ended_ || !unread_.empty()) {
    // The beginning of a line waits for its rest.
    if (!ended_ && unread_.find('\n') == std::string::npos && unread_.size() <= max_form_bytes) {
      listen();
      const std::optional<std::optional<std::string>> input = co_await lines_.pop();
      unread_ += input->value_or("");
      continue;
    }
    const std::size_t end = std::min(unread_.find('\n'), unread_.size() - 1) + 1;
    partial_ += unread_.substr(0, end);
    unread_.erase(0, end);
    const bool blank = partial_.find_first_not_of(" \t\r\n") == std::string::npos;
    const bool last = ended_ && unread_.empty();
    if (blank) {
      partial_.clear();
    } else if (last || partial_.size() > max_form_bytes || is_complete(partial_)) {
      co_return std::exchange(partial_, "");
    }
  }
  co_return std::nullopt;
}

void Terminal::print(const std::string& line) {
  if (prompting_) erase_line();
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
  if (prompting_) rl_forced_update_display();
}

}  // namespace pizarra::repl
