#pragma once

// What is wrong with an image file's bytes, told before they are decoded: what is damaged is decoded all the same, what
// is missing grey, and the library says so where nobody looks for it.
//
//   if (const std::string_view fault = fault_of_image(bytes); !fault.empty()) ... file + " " + fault

#include <span>
#include <string_view>

namespace pizarra {

// Empty where nothing is known to be wrong: all are held to a size that works, a PNG to its check sums and its end, a
// JPEG to its codes and its end.
std::string_view fault_of_image(std::span<const unsigned char> bytes);

}  // namespace pizarra
