#pragma once

// QUERY: the client starts, and waits for the answer: what a Caller does, under the name that the thesis' Table 4.4 has
// for it.
//
//   Result<Datum> pose = co_await query(caller, "robot", list("monitor"_sym), 2s);

#include "agents/runtime/service.hpp"

namespace pizarra::runtime {

inline Task<Result<Datum>> query(Caller& caller, std::string agent, Datum operation, Duration patience) {
  return caller.call(std::move(agent), std::move(operation), patience);
}

}  // namespace pizarra::runtime
