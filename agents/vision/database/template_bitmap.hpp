#pragma once

// A learned object's template as the bitmap file that a person can look at: a binary PGM of 32 x 32 pixels, the mark as
// it was seen, dark on light or light on dark.
//
//   Result<void> written = write_bitmap("objects/circle-1.pgm", sample.picture, sample.tone);
//   Result<MarkTemplate> picture = read_bitmap("objects/circle-1.pgm", sample.tone);

#include <filesystem>

#include "agents/vision/marks/mark_patch.hpp"
#include "agents/vision/marks/mark_signature.hpp"

namespace pizarra::vision {

// On the disk, whole, when it returns. Failures `disk-full` and `cannot-write`.
Result<void> write_bitmap(const std::filesystem::path& path, const MarkTemplate& picture, MarkTone tone);

// As it is, sound or damaged, and on the disk when it returns; one that is missing stays so. Failures the same.
Result<void> copy_bitmap(const std::filesystem::path& from, const std::filesystem::path& to);

// Failures `missing` and `damaged`.
Result<MarkTemplate> read_bitmap(const std::filesystem::path& path, MarkTone tone);

}  // namespace pizarra::vision
