#pragma once

// Ratios are taken in the same run: what is compared is run in turns, round by round, and each one's median told.
//
//   const std::vector<double> seconds = medians_in_turns(5, {[&] { tell_ours(); }, [&] { tell_theirs(); }});

#include <functional>
#include <span>
#include <vector>

namespace pizarra::bench {

double seconds_of(const std::function<void()>& work);

// What the calling thread itself computes, in seconds: nobody else's work on the same core is counted.
double thread_seconds_of(const std::function<void()>& work);

// Of every piece of work, in seconds.
std::vector<double> medians_in_turns(int rounds, const std::vector<std::function<void()>>& works);

// The same of what each piece of work answers.
std::vector<double> medians_of_rounds(int rounds, const std::vector<std::function<double()>>& works);

// The value below which `fraction` (0 to 1) of the samples lie; 0 of none.
double percentile(std::span<const double> samples, double fraction);

// The most memory this process ever had resident, in MB (VmHWM of /proc/self/status).
double peak_memory_mb();

}  // namespace pizarra::bench
