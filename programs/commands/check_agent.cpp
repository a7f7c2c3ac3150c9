#include "programs/commands/check_agent.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

#include "agents/scheme/program_contract.hpp"
#include "lisp/plain_text.hpp"
#include "programs/command_line/command_tools.hpp"

namespace pizarra::programs {

namespace {

constexpr std::array agent_words{"posts", "kind", "rule", "conclude", "loop", "operation", "define"};
constexpr std::array story_words{"declare", "tell", "retract", "expect", "absent", "call", "wait"};

// The text from its first parenthesis on that no comment holds; empty where other text comes before.
std::string_view from_first_form(std::string_view text) {
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    if (!text.starts_with(';')) break;
    text.remove_prefix(std::min(text.find('\n'), text.size()));
  }
  return text.starts_with('(') ? text : std::string_view();
}

std::string lower_case_word(std::string_view form) {
  if (form.empty()) return {};
  return lowered(form.substr(1, form.find_first_of(" \t\r\n();", 1) - 1));
}

// PDDL says (define (domain ...)) and (define (problem ...)), which Scheme could say too and hardly does.
bool is_pddl(std::string_view form) {
  if (lower_case_word(form) != "define") return false;
  const std::string defined = lower_case_word(from_first_form(form.substr(std::string_view("(define").size())));
  return defined == "domain" || defined == "problem";
}

std::size_t parts_of(const forms::AgentProgram& program, forms::ProgramPart::Sort sort) {
  return static_cast<std::size_t>(std::ranges::count(program.parts(), sort, &forms::ProgramPart::sort));
}

}  // namespace

bool is_agent_file(std::string_view text) {
  const std::string_view form = from_first_form(text);
  return !is_pddl(form) && std::ranges::find(agent_words, lower_case_word(form)) != agent_words.end();
}

Result<std::string> check_agent(const std::string& file, const std::string& text) {
  const std::string name = std::filesystem::path(file).stem().string();
  if (!is_symbol_name(name)) return fail("bad-name", file + ": an agent cannot be called as this file is");
  const auto program = forms::AgentProgram::load(name, text, std::filesystem::path(file).filename().string(), {});
  if (!program) return fail(program);
  const Result<runtime::Contract> contract = scheme::contract_of(program->get(), name);
  if (!contract) return fail(contract);
  using enum forms::ProgramPart::Sort;
  return fmt::format("agent {}: {}, {}, {}", name,
                     counted(parts_of(**program, rule) + parts_of(**program, conclusion), "rule"),
                     counted(parts_of(**program, loop), "loop"), counted(parts_of(**program, operation), "operation"));
}

bool is_agent_story(const Source& source) {
  return !source.data().empty() && std::ranges::find(story_words, source.data().front().head()) != story_words.end();
}

Result<std::string> check_agent_story(const Source& source) {
  for (std::size_t i = 0; i < source.data().size(); ++i) {
    const std::string_view head = source.data()[i].head();
    if (std::ranges::find(story_words, head) == story_words.end()) {
      return fail(source.failure_at(
          {i}, "malformed", fmt::format("a step of a story is one of ({} ...)", fmt::join(story_words, " ...), ("))));
    }
  }
  return fmt::format("story of an agent: {}", counted(source.data().size(), "step"));
}

}  // namespace pizarra::programs
