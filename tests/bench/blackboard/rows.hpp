#pragma once

// The figures of `bench blackboard`, one function and file each; main.cpp lists them.

#include "tests/bench/figures.hpp"

namespace pizarra::bench {

// Rounds of what is compared, in turns.
constexpr int rounds = 7;

void ask_replica(Figures& figures);
void in_process(Figures& figures);
void python_client(Figures& figures);
void tracing(Figures& figures);
void scheme_reaction(Figures& figures);
void start_and_memory(Figures& figures);
void tell_round_trip(Figures& figures);
void tell_to_watcher(Figures& figures);
void text_door(Figures& figures);
void throughput(Figures& figures);
void durable_tells(Figures& figures);
void recovery(Figures& figures);
void stalled_watcher(Figures& figures);
void streams(Figures& figures);

}  // namespace pizarra::bench
