#pragma once

// What every command of the prompt is given: the board, the agents to ask, and how to show an answer.
//
//   Task<Evaluation> tell_fact(Prompt& prompt, Typed typed) {
//     if (typed.form.size() != 2) co_return prompt.misused(typed);
//     const Result<Revision> told = co_await prompt.board.tell(typed.form[1]);
//     if (!told) co_return prompt.show(told.error());
//     prompt.say("told", "{\"told\":true}");
//     co_return Evaluation::done;
//   }
//
// It is never copied and outlives the commands.

#include <functional>
#include <string>
#include <string_view>

#include "agents/runtime/caller.hpp"
#include "lisp/reader.hpp"

namespace pizarra::repl {

enum class Evaluation : std::uint8_t {
  done,
  failed,       // an agent or the board did not do it
  unavailable,  // the board did not answer
  refused,      // the goal was understood and cannot be reached
  malformed,    // what was typed could not be read or is not a command
  quit,
};

enum class Style : std::uint8_t { text, json };

using Output = std::function<void(const std::string& line)>;

// A command as it was typed, and how it is written.
struct Typed {
  Datum form;
  std::string_view usage;
};

struct Prompt {
  Prompt(runtime::AgentContext& agent_context, const runtime::Service& service, Output output, Style output_style)
      : context(agent_context),
        board(agent_context.board),
        caller(agent_context, service),
        print(std::move(output)),
        style(output_style) {}
  Prompt(const Prompt&) = delete;
  Prompt& operator=(const Prompt&) = delete;

  // One of the two, by the style.
  void say(const std::string& text, const std::string& json) const { print(style == Style::json ? json : text); }
  Evaluation show(const Failure& failure, Evaluation outcome) const;
  // Shows the board's answer, or that none came.
  Evaluation show(const Failure& failure) const;
  // Shows how the command is written.
  Evaluation misused(const Typed& typed) const;

  runtime::AgentContext& context;
  Board& board;
  runtime::Caller caller;
  Output print;  // a line that is the same in both styles
  Style style;
};

// A pattern of ours, which can be read.
inline Datum read_pattern(std::string_view text) { return read_one(text).value(); }

// A person who leaves the parentheses of a lone command away is understood.
inline Datum as_form(const Datum& typed) { return typed.is_symbol() ? list(typed) : typed; }

}  // namespace pizarra::repl
