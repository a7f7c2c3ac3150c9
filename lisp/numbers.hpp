#pragma once

// Numbers as facts and files tell them: with few digits, and angles in degrees.
//
//   rounded(0.126, 100);            // 0.13
//   degrees(radians(90));           // 90

#include <cmath>
#include <numbers>

namespace pizarra {

// To the nearest of so many parts of one: rounded(0.126, 100) is 0.13. Never a negative zero.
inline double rounded(double value, double parts) { return std::round(value * parts) / parts + 0.0; }

inline double degrees(double rad) { return rad * 180 / std::numbers::pi; }
inline double radians(double deg) { return deg * std::numbers::pi / 180; }

}  // namespace pizarra
