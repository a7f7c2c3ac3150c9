#pragma once

// Connect: recommends a connection's pattern, by the thesis' Tables 4.4 and 4.5. It depends on the number of
// addressees, on whether the client waits, and on the balance of the bytes there and back.
//
//   recommend({.addressees = 1, .waits = true, .bytes = 40, .bytes_back = 20});     // QUERY

#include "programs/method/system.hpp"

namespace pizarra::method {

// A message of so many bytes is heavy: a page of text, far more than any command.
inline constexpr double heavy_bytes = 1024;
// A client that waits longer for an answer had better be pushed it: the thesis asks its eyes to answer within 2 s.
inline constexpr double long_wait_ms = 2000;

struct Nature {
  std::size_t addressees = 1;
  bool waits = false;
  double bytes = 0;       // from who begins
  double bytes_back = 0;  // to it
};

std::string recommend(const Nature& nature);

// Fills in what is recommended, and why where that is another pattern than was seen.
void advise(Connection& connection, double seconds);

}  // namespace pizarra::method
