#include "drivers/simulation/controllers/arms/hses_variables.hpp"

#include <algorithm>
#include <iterator>

#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::size_t most_octets = 474;  // of several at once

constexpr std::size_t pose_octets = 13 * 4;  // type, form, tool, user frame, extended form and 8 axes
constexpr std::size_t axes_octets = 9 * 4;   // type and 8 axes

}  // namespace

const HsesVariables::Kind HsesVariables::kinds[] = {
    {0x78, 1, 8220, 1, 1},           // inputs and outputs, eight each
    {0x79, 0, 999, 2, 2},            // registers
    {0x7a, 0, 99, 1, 1},             // B
    {0x7b, 0, 99, 2, 2},             // I
    {0x7c, 0, 99, 4, 4},             // D
    {0x7d, 0, 99, 4, 4},             // R
    {0x7e, 0, 99, 16, 16},           // S
    {0x7f, 0, 127, pose_octets, 4},  // P
    {0x80, 0, 127, axes_octets, 4},  // BP
    {0x81, 0, 127, axes_octets, 4},  // EX
};

// Of inputs and outputs, those of the network are set from outside, of registers the first.
bool HsesVariables::may_be_set(const Kind& kind, std::uint16_t number) {
  constexpr std::uint16_t registers = 0x79;
  constexpr std::uint16_t last_register = 559;
  if (kind.command == registers) return number <= last_register;
  return kind.command != hses::network_io || (number >= 2501 && number <= 2756);
}

const HsesVariables::Kind* HsesVariables::kind_of(std::uint16_t command) {
  const Kind* found = std::ranges::find(kinds, command, &Kind::command);
  return found == std::end(kinds) ? nullptr : found;
}

bool HsesVariables::has(std::uint16_t command) {
  return kind_of(command) != nullptr || kind_of(static_cast<std::uint16_t>(command - hses::plural)) != nullptr;
}

Task<HsesOutcome> HsesVariables::carry_out(arm::HsesRequest request) {
  if (const Kind* kind = kind_of(request.command)) return one(std::move(request), *kind);
  const Kind* kind = kind_of(static_cast<std::uint16_t>(request.command - hses::plural));
  return several(std::move(request), *kind);
}

Task<std::string> HsesVariables::value(Kind kind, std::uint16_t number) {
  if (kind.command == arm::hses::double_integer) {
    const std::int32_t held = co_await controller_.variable(number);
    co_return line::OctetWriter(line::ByteOrder::little).i32(held).octets();
  }
  const auto found = values_.find({kind.command, number});
  co_return found == values_.end() ? std::string(kind.octets, '\0') : found->second;
}

Task<std::uint16_t> HsesVariables::set_value(Kind kind, std::uint16_t number, std::string octets) {
  if (!may_be_set(kind, number)) co_return hses::not_to_be_set;
  if (kind.command == arm::hses::double_integer) {
    const std::int32_t wanted = line::OctetReader(octets, line::ByteOrder::little).i32();
    const Refusal refusal = co_await controller_.set_variable(number, wanted);
    co_return hses_code(refusal);
  }
  values_[{kind.command, number}] = std::move(octets);
  co_return std::uint16_t{0};
}

Task<HsesOutcome> HsesVariables::one(arm::HsesRequest request, Kind kind) {
  HsesOutcome outcome;
  outcome.refusal = arm::hses::wrong_instance;
  if (request.instance < kind.first || request.instance > kind.last) co_return outcome;
  std::string held = co_await value(kind, request.instance);
  if (request.service == arm::hses::get_all || request.service == arm::hses::get_one) {
    std::vector<std::string> elements;
    for (std::size_t at = 0; at < kind.octets; at += kind.element) elements.push_back(held.substr(at, kind.element));
    co_return hses_elements(request, elements);
  }
  const bool all = request.service == arm::hses::set_all;
  const std::size_t elements = kind.octets / kind.element;
  const bool attribute = all ? request.attribute == 0 : request.attribute >= 1 && request.attribute <= elements;
  outcome.refusal = 0;
  if (!all && request.service != arm::hses::set_one) outcome.refusal = arm::hses::undefined_command;
  if (outcome.refusal == 0 && !attribute) outcome.refusal = arm::hses::wrong_attribute;
  const std::size_t size = all ? kind.octets : kind.element;
  if (outcome.refusal == 0 && request.data.size() != size) outcome.refusal = arm::hses::wrong_size;
  if (outcome.refusal != 0) co_return outcome;
  held.replace(all ? 0 : (request.attribute - 1u) * kind.element, size, request.data);
  outcome.refusal = co_await set_value(kind, request.instance, std::move(held));
  co_return outcome;
}

Task<HsesOutcome> HsesVariables::several(arm::HsesRequest request, Kind kind) {
  HsesOutcome outcome;
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::uint32_t count = read.u32();
  const std::string given(read.rest());
  const bool reads = request.service == hses::get_several;
  const bool fits = count >= 1 && count * kind.octets <= most_octets && (kind.octets > 1 || count % 2 == 0);
  if (!reads && request.service != hses::set_several) {
    outcome.refusal = arm::hses::undefined_command;
  } else if (request.attribute != 0) {
    outcome.refusal = arm::hses::wrong_attribute;
  } else if (request.data.size() < 4 || !fits || given.size() != (reads ? 0 : count * kind.octets)) {
    outcome.refusal = arm::hses::wrong_size;
  } else if (request.instance < kind.first || request.instance + count - 1 > kind.last) {
    outcome.refusal = arm::hses::wrong_instance;
  }
  if (outcome.refusal != 0) co_return outcome;
  if (reads) outcome.data = request.data;
  for (std::uint32_t i = 0; i < count && outcome.refusal == 0; ++i) {
    const auto number = static_cast<std::uint16_t>(request.instance + i);
    if (reads) {
      const std::string held = co_await value(kind, number);
      outcome.data += held;
    } else {
      std::string octets = given.substr(i * kind.octets, kind.octets);
      outcome.refusal = co_await set_value(kind, number, std::move(octets));
    }
  }
  co_return outcome;
}

}  // namespace pizarra::simulation
