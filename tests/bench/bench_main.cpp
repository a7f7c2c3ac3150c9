#include "tests/bench/bench_main.hpp"

#include <csignal>
#include <cstdio>

#include "tests/bench/stopping.hpp"

namespace pizarra::bench {

int bench_main(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run();
  } catch (const std::exception& error) {
    constexpr int of_signals = 128;
    // Whoever stopped the bench may have stopped its processes as well: what failed then says nothing.
    const std::string why = stopped_by() != 0 ? Stopped().what() : error.what();
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), why.c_str());
    return stopped_by() != 0 ? of_signals + stopped_by() : 1;
  }
}

}  // namespace pizarra::bench
