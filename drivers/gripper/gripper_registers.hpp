#pragma once

// The fields of a gripper in its 16-bit registers, as data: a cell file may place them for any gripper
// (lisp/forms/gripper_setup.hpp). The emulated gripper is read by the same.
//
//   const GripperSetup setup;
//   RegisterImage orders(orders_of(setup));
//   orders.put(setup.target, 255);            // some bits of one of its registers
//
// The values of the fields are those of Robotiq's two-finger grippers: `active` 3 is ready to move; `object` 0 the
// fingers move, 1 and 2 something stopped them as they opened and closed, 3 they are where they were sent; `fault` 0 is
// none. Facts from: public drivers of these grippers.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lisp/forms/gripper_setup.hpp"

namespace pizarra::gripper {

namespace gripper {

inline constexpr std::uint16_t ready = 3;       // of `active`
inline constexpr std::uint16_t on_its_way = 0;  // of `object`
inline constexpr std::uint16_t met_opening = 1;
inline constexpr std::uint16_t met_closing = 2;
inline constexpr std::uint16_t arrived = 3;

}  // namespace gripper

// The fields that a gripper is told, and those that it tells.
inline std::array<forms::RegisterField, 5> orders_of(const forms::GripperSetup& setup) {
  return {setup.activate, setup.go, setup.target, setup.speed_field, setup.force_field};
}
inline std::array<forms::RegisterField, 4> states_of(const forms::GripperSetup& setup) {
  return {setup.active, setup.object, setup.fault, setup.opening};
}

// Registers that lie together.
class RegisterImage {
 public:
  RegisterImage(int first, std::vector<std::uint16_t> values) : first_(first), values_(std::move(values)) {}
  // Those from the first to the last of the fields, all 0.
  explicit RegisterImage(std::span<const forms::RegisterField> fields)
      : first_(std::ranges::min(fields, {}, &forms::RegisterField::number).number),
        values_(static_cast<std::size_t>(std::ranges::max(fields, {}, &forms::RegisterField::number).number - first_ +
                                         1)) {}

  int first() const { return first_; }
  const std::vector<std::uint16_t>& values() const { return values_; }
  std::uint16_t get(const forms::RegisterField& field) const {
    return static_cast<std::uint16_t>(at(field) >> field.low_bit & mask(field));
  }
  void put(const forms::RegisterField& field, std::uint16_t value) {
    std::uint16_t& whole = values_[static_cast<std::size_t>(field.number - first_)];
    whole =
        static_cast<std::uint16_t>((whole & ~(mask(field) << field.low_bit)) | (value & mask(field)) << field.low_bit);
  }

 private:
  std::uint16_t at(const forms::RegisterField& field) const {
    return values_[static_cast<std::size_t>(field.number - first_)];
  }
  static unsigned mask(const forms::RegisterField& field) { return (1u << field.bits) - 1; }

  int first_;
  std::vector<std::uint16_t> values_;
};

}  // namespace pizarra::gripper
