#pragma once

// The end of a bench's main(): reads the arguments, measures, and says what kept it from that.
//
//   return pizarra::bench::bench_main(app, argc, argv, [&] { return run(choices); });

#include <CLI/CLI.hpp>
#include <functional>

namespace pizarra::bench {

// The exit status: that of `run`, 2 for wrong arguments, 1 where it throws, 130 or 143 where a signal had it throw
// (stopping.hpp).
int bench_main(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace pizarra::bench
