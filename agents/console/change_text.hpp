#pragma once

// The console's answers to the page, as JSON: facts and values as their text, which the page reads as any reader of
// ours does.
//
//   change_text(7, change)   {"watch":7,"revision":12,"resynchronised":true,"cut":0,"removed":[],
//                             "added":[{"ids":[3],"bindings":{"?x":"circle"},
//                                       "facts":[{"text":"(clear circle)","teller":"coordinator","when":...}]}]}
//
//   refusal_text(3, failure)     {"reply":3,"error":{"symbol":...},"said":"what a prompt would say of it"}
//
// A failure's texts are cut to some 2 kB in all. Of more answers than a page shows, or larger ones, the first ones go,
// and `cut` says how many are left out.

#include <cstdint>
#include <string>

#include "blackboard/board.hpp"
#include "lisp/json.hpp"

namespace pizarra::console {

constexpr std::size_t most_answers = 2000;
constexpr std::size_t most_answer_bytes = 1 << 20;

std::string change_text(std::int64_t watch, const Change& change);
// One of its answers: of a fact alone.
std::string told_text(const Fact& fact);
std::string failed_watch_text(std::int64_t watch, const Failure& failure);

// A request's answer: its values, strings as they are and everything else as its text.
std::string reply_text(std::int64_t request, const Datum& values);
std::string refusal_text(std::int64_t request, const Failure& failure);

// One of these texts with the moment of which it is, "past", in microseconds; as it is where that is empty: now.
std::string of_the_past(std::string text, const std::string& past);

}  // namespace pizarra::console
