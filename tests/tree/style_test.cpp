#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <regex>

#include "tests/tree/tree.hpp"

namespace pizarra {
namespace {

const std::vector<std::string> everywhere = {"lisp", "blackboard", "drivers", "agents", "programs", "tests"};

// From the end of the statement before to the end of this one; a `;` inside a for's parentheses ends nothing that
// matters.
std::string_view statement_around(std::string_view code, std::size_t offset) {
  const std::size_t before = code.find_last_of(";{}", offset);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t end = code.find(';', offset);
  return code.substr(begin, end == std::string_view::npos ? end : end - begin);
}

// Whether the brace that opened just before the statement belongs to an initialiser rather than to a block.
bool follows_initialiser_brace(std::string_view code, std::size_t statement) {
  if (statement == 0 || code[statement - 1] != '{') return false;
  std::size_t i = statement - 1;
  while (i > 0 && std::isspace(static_cast<unsigned char>(code[i - 1]))) --i;
  if (i == 0) return false;
  const char last = code[i - 1];
  if (std::isalnum(static_cast<unsigned char>(last)) || last == '_') {
    std::size_t begin = i;
    while (begin > 0 && std::isalnum(static_cast<unsigned char>(code[begin - 1]))) --begin;
    const std::string_view word = code.substr(begin, i - begin);
    constexpr std::string_view before_blocks[] = {"else", "do", "try", "const", "override", "final", "noexcept"};
    return std::ranges::find(before_blocks, word) == std::end(before_blocks);
  }
  return last == ',' || last == '(' || last == '=';
}

std::vector<std::string> coroutine_faults(std::string_view text) {
  const std::string code = without_comments_and_literals(text);
  std::vector<std::string> faults;
  for (std::size_t at = code.find("co_await"); at != std::string::npos; at = code.find("co_await", at + 1)) {
    const std::string_view statement = statement_around(code, at);
    const auto begin = static_cast<std::size_t>(statement.data() - code.data());
    for (const std::string_view banned : {"{", "?", "&&", "||"}) {
      if (statement.find(banned) == std::string_view::npos) continue;
      faults.push_back("line " + std::to_string(line_of(code, at)) + ": co_await beside " + std::string(banned));
    }
    if (follows_initialiser_brace(code, begin)) {
      faults.push_back("line " + std::to_string(line_of(code, at)) + ": co_await inside an initialiser");
    }
  }
  return faults;
}

TEST(CoroutineStyle, TheCheckItselfSeesWhatItLooksFor) {
  EXPECT_TRUE(coroutine_faults("{ const int a = co_await f(b); }").empty());
  EXPECT_TRUE(coroutine_faults("if (x) {\n  co_await f(b);\n}").empty());
  EXPECT_TRUE(coroutine_faults("// co_await x ? y : z;\n").empty());
  EXPECT_FALSE(coroutine_faults("{ a = b ? co_await f() : 0; }").empty());
  EXPECT_FALSE(coroutine_faults("{ co_await f(T{1}); }").empty());
  EXPECT_FALSE(coroutine_faults("{ T t = T{co_await f()}; }").empty());
  EXPECT_FALSE(coroutine_faults("{ if (a && co_await f()) g(); }").empty());
  EXPECT_FALSE(coroutine_faults("{ co_await f([] { return 1; }); }").empty());
}

// g++ 12 miscompiles some of what is refused here.
TEST(CoroutineStyle, NoStatementWithCoAwaitHoldsBracesConditionalsOrLambdas) {
  for (const SourceFile& file : sources_below(everywhere)) {
    for (const std::string& fault : coroutine_faults(file.text)) ADD_FAILURE() << file.path << " " << fault;
  }
}

TEST(Style, AgentsReadNoWallClockAndStartNoThread) {
  static const std::regex banned(
      R"(std::chrono::(system|steady|high_resolution)_clock|std::j?thread\b(?!::id)|sleep_for|usleep|random_device|\btime\(|\brand\()");
  for (const SourceFile& file : sources_below({"lisp", "blackboard", "drivers", "agents"})) {
    // Real time lives in one file, its threads in another, those that nobody waits for in a third; the launcher runs
    // processes and tells how long a run took.
    constexpr std::string_view exempt[] = {"blackboard/time/real_executor", "blackboard/time/worker_pool",
                                           "blackboard/time/detached_work", "agents/launcher/", "programs/"};
    if (std::ranges::any_of(exempt, [&](std::string_view name) { return file.path.starts_with(name); })) continue;
    std::smatch found;
    const std::string code = without_comments_and_literals(file.text);
    EXPECT_FALSE(std::regex_search(code, found, banned)) << file.path << ": " << found[0];
  }
}

TEST(Style, EveryPublicHeaderOpensWithWhatItIsFor) {
  for (const SourceFile& file : sources_below({"lisp", "blackboard", "drivers", "agents"})) {
    if (!file.path.ends_with(".hpp")) continue;
    EXPECT_TRUE(file.text.starts_with("#pragma once\n\n//")) << file.path;
  }
}

}  // namespace
}  // namespace pizarra
