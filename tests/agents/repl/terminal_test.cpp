// The prompt as a person sees it: a program behind a pseudo-terminal, its keys, and what stands on the screen.

#include "agents/repl/terminal.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include "blackboard/time/real_executor.hpp"
#include "tests/agents/repl/screen.hpp"
#include "tests/scratch.hpp"

namespace pizarra::repl {
namespace {

constexpr int columns = 40;
constexpr auto patience = std::chrono::seconds(10);

const std::set<std::string>& known_words() {
  static const std::set<std::string> words{"circle", "objects"};
  return words;
}

// Says what was read; `(wait)` is work that only Ctrl-C ends.
Task<void> echo(Terminal& terminal, Event& interrupted) {
  while (true) {
    const std::optional<std::string> form = co_await terminal.read();
    if (!form) co_return;
    terminal.print("read " + form->substr(0, form->find_last_not_of('\n') + 1));
    const bool work = form->starts_with("(wait)");
    if (work) co_await interrupted.wait();
    interrupted.reset();
  }
}

// Whatever comes on the file `news` is printed, as what agents do is.
int prompt_program(int news) {
  RealExecutor executor;
  Terminal terminal(executor, "> ");
  Event interrupted(executor);
  terminal.words = known_words;
  terminal.on_interrupt = [&] { interrupted.set(); };
  executor.watch_readable(news, [&] {
    char text[100];
    const ssize_t got = ::read(news, text, sizeof text);
    terminal.print(std::string(text, static_cast<std::size_t>(std::max<ssize_t>(got, 0))));
  });
  const Job job = executor.spawn(echo(terminal, interrupted));
  executor.run_until([&job] { return job.done(); });
  executor.unwatch_readable(news);
  return terminal.interrupted() ? 130 : 0;
}

class TerminalTest : public testing::Test {
 protected:
  void SetUp() override {
    home_ = scratch_folder() + "home";
    std::filesystem::remove_all(home_);
    begin();
  }
  void TearDown() override {
    if (child_ > 0) kill(child_, SIGKILL);
    if (child_ > 0) waitpid(child_, nullptr, 0);
    std::filesystem::remove_all(home_);
  }

  void begin() {
    int news[2];
    ASSERT_EQ(pipe(news), 0);
    winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    child_ = forkpty(&terminal_, nullptr, nullptr, &size);
    ASSERT_GE(child_, 0);
    if (child_ == 0) {
      setenv("TERM", "xterm", 1);
      setenv("HOME", home_.c_str(), 1);
      setenv("XDG_STATE_HOME", home_.c_str(), 1);
      _exit(prompt_program(news[0]));
    }
    close(news[0]);
    news_ = news[1];
    screen_ = Screen(columns);
    sees("> ");
  }

  void type(std::string_view keys) {
    ASSERT_EQ(write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  void tell(std::string_view text) {
    ASSERT_EQ(write(news_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

  bool take(std::chrono::steady_clock::time_point deadline) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd ready{terminal_, POLLIN, 0};
    if (left.count() <= 0 || poll(&ready, 1, static_cast<int>(left.count())) <= 0) return false;
    char bytes[4096];
    const ssize_t got = read(terminal_, bytes, sizeof bytes);
    if (got > 0) screen_.write({bytes, static_cast<std::size_t>(got)});
    return got > 0;
  }

  // Waits until the screen shows just this; blanks at its end do not show.
  void sees(std::string_view expected) {
    const std::string shown(expected.substr(0, expected.find_last_not_of(" \n") + 1));
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (screen_.text() != shown && take(deadline)) {
    }
    EXPECT_EQ(screen_.text(), shown);
  }

  int status() {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (take(deadline)) {
    }
    if (std::chrono::steady_clock::now() >= deadline) return -1;
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  std::string home_;
  pid_t child_ = -1;
  int terminal_ = -1;
  int news_ = -1;
  Screen screen_{columns};
};

TEST_F(TerminalTest, ControlCDropsWhatWasTypedAndGivesAFreshPrompt) {
  type("(objets");
  sees("> (objets");
  type("\x03");
  sees("> (objets^C\n> ");
  type("(plan)\r");
  sees("> (objets^C\n> (plan)\nread (plan)\n> ");
}

TEST_F(TerminalTest, ControlCDropsTheEarlierLinesOfAFormToo) {
  type("(ask\r");
  sees("> (ask\n     ...");
  type("\x03");
  sees("> (ask\n     ... ^C\n> ");
  type("(plan)\r");
  sees("> (ask\n     ... ^C\n> (plan)\nread (plan)\n> ");
}

TEST_F(TerminalTest, ControlCOnAnEmptyLineEnds) {
  type("\x03");
  EXPECT_EQ(status(), 130);
}

TEST_F(TerminalTest, ControlCOnALineThatWasTakenBackEnds) {
  type("(a");
  sees("> (a");
  type("\x7f\x7f");
  sees("> ");
  type("\x03");
  EXPECT_EQ(status(), 130);
}

TEST_F(TerminalTest, ControlCWithTheCursorAtTheBeginningDropsTheLine) {
  type("(a)");
  sees("> (a)");
  type("\x01(b)");
  sees("> (b)(a)");
  type("\x01\x03");
  sees("> (b)(a)^C\n> ");
}

TEST_F(TerminalTest, ControlCDuringWorkIsToldAndThePromptComesBack) {
  type("(wait)\r");
  sees("> (wait)\nread (wait)");
  type("\x03");
  sees("> (wait)\nread (wait)\n^C> ");
}

TEST_F(TerminalTest, ControlDOnAnEmptyLineEnds) {
  type("\x04");
  EXPECT_EQ(status(), 0);
}

TEST_F(TerminalTest, WhatComesMeanwhileStandsAboveWhatIsTypedOnce) {
  type("(ask");
  sees("> (ask");
  tell("news");
  sees("news\n> (ask");
  type(" (on))\r");
  sees("news\n> (ask (on))\nread (ask (on))\n> ");
}

TEST_F(TerminalTest, WhatComesMeanwhileKeepsThePlaceOfTheCursor) {
  type("(ak)");
  sees("> (ak)");
  type("\x02\x02");  // back before the k
  tell("news");
  sees("news\n> (ak)");
  type("s");
  sees("news\n> (ask)");
}

TEST_F(TerminalTest, WhatComesMeanwhileLeavesNothingOfALongLineBehind) {
  const std::string typed = "(ask (and (on ?x ?y) (on ?y ?z) (clear ?x)";
  type(typed);
  sees("> " + typed.substr(0, columns - 2) + "\n" + typed.substr(columns - 2));
  tell("news");
  sees("news\n> " + typed.substr(0, columns - 2) + "\n" + typed.substr(columns - 2));
  type("\x03");
  sees("news\n> " + typed.substr(0, columns - 2) + "\n" + typed.substr(columns - 2) + "^C\n> ");
}

TEST_F(TerminalTest, WhatComesBeforeAnyKeyLeavesOnePrompt) {
  type("(plan)\r");
  sees("> (plan)\nread (plan)\n> ");
  tell("news");
  sees("> (plan)\nread (plan)\nnews\n> ");
}

TEST_F(TerminalTest, SeveralLinesPastedAreReadOneAfterAnother) {
  type("(a)\r(b\r c)\r(d)\r");
  sees("> (a)\nread (a)\n> (b\n     ...  c)\nread (b\n c)\n> (d)\nread (d)\n> ");
}

TEST_F(TerminalTest, TabCompletesAName) {
  type("(obj\t");
  sees("> (objects");
}

TEST_F(TerminalTest, TheHistoryIsThereAgainTheNextTime) {
  type("(first)\r");
  sees("> (first)\nread (first)\n> ");
  type("\x04");
  ASSERT_EQ(status(), 0);
  begin();
  type("\x10");  // the line before
  sees("> (first)");
}

TEST_F(TerminalTest, LettersOfOtherAlphabetsStandAsTheyWereTyped) {
  type(
      "(pi\xC3\xB1"
      "a");
  tell("news");
  sees(
      "news\n> (pi\xC3\xB1"
      "a");
}

}  // namespace
}  // namespace pizarra::repl
