#pragma once

// The commands about the facts of the board, whatever they mean: ask, declare, tell, retract.
//
//   Evaluation outcome = co_await ask_board(prompt, typed);       // (ask (on ?x ?y))

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

Task<Evaluation> ask_board(Prompt& prompt, Typed typed);
Task<Evaluation> declare_relation(Prompt& prompt, Typed typed);
Task<Evaluation> tell_fact(Prompt& prompt, Typed typed);
Task<Evaluation> retract_facts(Prompt& prompt, Typed typed);

}  // namespace pizarra::repl
