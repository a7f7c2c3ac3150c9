// Tells libFuzzer which code an input reached, for code that g++ built: clang 14 cannot compile libstdc++ 12's
// <expected>, and g++ knows only -fsanitize-coverage=trace-pc, which libFuzzer has given up hearing.

#include <array>
#include <cstddef>
#include <cstdint>

namespace {

constexpr std::size_t counted = 1 << 16;
__attribute__((section("__libfuzzer_extra_counters"))) std::array<std::uint8_t, counted> counters;

}  // namespace

extern "C" {

// Linked in place of libFuzzer's own, with --wrap.
__attribute__((no_sanitize_coverage)) void __wrap___sanitizer_cov_trace_pc() {
  const auto place = reinterpret_cast<std::uintptr_t>(__builtin_return_address(0));
  constexpr std::uintptr_t scatter = 0x9E3779B97F4A7C15U;
  std::uint8_t& counter = counters.data()[place * scatter >> 48];
  if (counter < 255) ++counter;
}

__attribute__((no_sanitize_coverage)) void __sanitizer_cov_trace_cmpd(double, double) {}
__attribute__((no_sanitize_coverage)) void __sanitizer_cov_trace_cmpf(float, float) {}
}
