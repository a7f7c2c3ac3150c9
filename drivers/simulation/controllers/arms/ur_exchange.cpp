#include "drivers/simulation/controllers/arms/ur_exchange.hpp"

#include <cmath>

#include "drivers/arm/universal/rtde.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::size_t most_input_recipes = 30;
constexpr char controller_version = 'v';
constexpr char pause_message = 'P';

std::string one_octet(std::size_t value) { return std::string(1, static_cast<char>(value)); }

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    names.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return names;
}

std::string joined(const std::vector<std::string_view>& types) {
  std::string all;
  for (const std::string_view type : types) all += (all.empty() ? "" : ",") + std::string(type);
  return all;
}

}  // namespace

std::string UrExchange::answer(std::string_view message) {
  const char type = message.front();
  const std::string_view payload = message.substr(1);
  if (type == arm::rtde::version) {
    const std::uint16_t wanted = line::OctetReader(payload, line::ByteOrder::big).u16();
    return arm::rtde::write(type, one_octet(wanted == 2 ? 1 : 0));
  }
  if (type == controller_version) {
    constexpr std::uint32_t build = 108249;
    return arm::rtde::write(type, line::OctetWriter(line::ByteOrder::big).u32(5).u32(11).u32(0).u32(build).octets());
  }
  if (type == arm::rtde::outputs) return agree_on_outputs(payload);
  if (type == arm::rtde::inputs) return agree_on_inputs(payload);
  if (type == arm::rtde::start) {
    telling_ = !outputs_.empty();
    return arm::rtde::write(type, one_octet(telling_ ? 1 : 0));
  }
  if (type == pause_message) {
    telling_ = false;
    return arm::rtde::write(type, one_octet(1));
  }
  return "";
}

// Names that there are not are named so, and the recipe is none.
std::string UrExchange::agree_on_outputs(std::string_view payload) {
  line::OctetReader read(payload, line::ByteOrder::big);
  const double per_s = read.f64();
  Recipe recipe;
  std::vector<std::string_view> types;
  for (std::string& name : names_in(read.rest())) {
    const std::optional<UrType> type = ur_output_type(name);
    types.push_back(type ? ur_type_name(*type) : "NOT_FOUND");
    if (type) recipe.push_back({std::move(name), *type});
  }
  constexpr double most_per_s = 500;
  const bool whole = !recipe.empty() && recipe.size() == types.size() && per_s >= 1 && per_s <= most_per_s;
  telling_ = false;
  outputs_ = whole ? std::move(recipe) : Recipe();
  if (whole) period_ = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / per_s));
  return arm::rtde::write(arm::rtde::outputs, one_octet(whole ? output_recipe : 0) + joined(types));
}

std::string UrExchange::agree_on_inputs(std::string_view names) {
  Recipe recipe;
  std::vector<std::string_view> types;
  for (std::string& name : names_in(names)) {
    const std::optional<UrType> type = ur_input_type(name);
    types.push_back(type ? ur_type_name(*type) : "NOT_FOUND");
    if (type) recipe.push_back({std::move(name), *type});
  }
  const bool whole = !recipe.empty() && recipe.size() == types.size() && inputs_.size() < most_input_recipes;
  if (whole) inputs_.push_back(std::move(recipe));
  return arm::rtde::write(arm::rtde::inputs, one_octet(whole ? inputs_.size() : 0) + joined(types));
}

std::vector<std::pair<std::string, double>> UrExchange::take(std::string_view payload) const {
  line::OctetReader read(payload, line::ByteOrder::big);
  const std::size_t number = read.u8();
  if (number < 1 || number > inputs_.size()) return {};
  std::vector<std::pair<std::string, double>> taken;
  for (const Field& field : inputs_[number - 1]) taken.emplace_back(field.name, read_ur_number(read, field.type));
  if (!read.whole()) return {};
  for (const auto& [name, value] : taken) {
    if (!std::isfinite(value)) return {};
  }
  return taken;
}

std::string UrExchange::tell(const UrState& state) const {
  line::OctetWriter octets(line::ByteOrder::big);
  octets.u8(output_recipe);
  for (const Field& field : outputs_) write_ur_value(octets, field.type, state.value(field.name));
  return arm::rtde::write(arm::rtde::data, octets.octets());
}

}  // namespace pizarra::simulation
