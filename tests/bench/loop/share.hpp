#pragma once

// How sure a share of runs is: Wilson's interval at 95 %.
//
//   const Share share = share_of(298, 300);      // 99.3 %, between 97.6 % and 99.8 %

namespace pizarra::bench {

// In percent.
struct Share {
  double percent = 0;
  double low = 0;
  double high = 0;
};

// Of no runs, nothing is known: 0 between 0 and 100.
Share share_of(int successes, int runs);

}  // namespace pizarra::bench
