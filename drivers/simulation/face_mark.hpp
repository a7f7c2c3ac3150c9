#pragma once

// What is on a cube's faces: one of the drawn shapes, or a tag of a family that OpenCV knows.
//
//   const std::optional<FaceMark> mark = face_mark_from_name("apriltag-36h11-17");      // or "letter-h"
//   face_mark_name(*mark);                                                              // the same again

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pizarra::simulation {

enum class Mark : std::uint8_t {
  circle,
  square,
  cross,
  triangle,
  arrow,
  hourglass,
  house,
  star,
  letter_h,
  letter_t,
  letter_y,
  letter_z
};

// Such as "circle" and "letter-h"; nothing for another word.
std::optional<Mark> mark_from_name(std::string_view name);
std::string_view mark_name(Mark mark);
std::span<const std::string_view> mark_names();

// How a tag is printed: square cells, row by row, its dark border among them.
struct TagPrint {
  int side = 0;  // cells
  std::vector<bool> light;
  bool is_light(int column, int row) const { return light[static_cast<std::size_t>(row * side + column)]; }
};

struct TagMark {
  std::string name;  // family and number, such as apriltag-36h11-17
  std::shared_ptr<const TagPrint> print;
};

// The side of a tag's dark square, of the edge of its cube. With less light ground around it the cube's edges, and the
// tag on the next face, are so near in the image that its corners are taken for theirs.
inline constexpr double tag_part_of_edge = 0.6;

using FaceMark = std::variant<Mark, TagMark>;

// As the camera sees an unturned cube; its x looks out of the front, its y out of the right one.
enum class CubeFace : std::uint8_t { front, back, right, left, top, bottom };

// Such as "front"; nothing for another word.
std::optional<CubeFace> cube_face_from_name(std::string_view name);

// What is on each CubeFace; nothing on one that is plain.
using CubeMarks = std::array<std::optional<FaceMark>, 6>;
CubeMarks on_each_face(const FaceMark& mark);

// Nothing for a word that is no shape's and no tag's, and for a number that a family does not have.
std::optional<FaceMark> face_mark_from_name(std::string_view name);
std::string face_mark_name(const FaceMark& mark);

}  // namespace pizarra::simulation
