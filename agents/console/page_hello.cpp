#include "agents/console/page_hello.hpp"

#include <fmt/format.h>

#include "agents/console/change_text.hpp"
#include "agents/console/page_images.hpp"

namespace pizarra::console {

namespace {

std::string reach_text(const ReachOutline& reach) {
  std::string parts;
  for (const ReachOutline::Part& reached : reach.parts) {
    parts += fmt::format("{}[{:.0f},{:.0f}]", parts.empty() ? "" : ",", reached.from_mm, reached.to_mm);
  }
  return fmt::format("{{\"height\":{:.1f},\"parts\":[{}]}}", reach.height_mm, parts);
}

// Each axis by its name and the unit of its readings.
std::string axes_text(const arm::ArmModel& model) {
  std::string axes;
  for (const arm::Axis& axis : model.axes) {
    const std::string_view unit = arm::slides(axis.role) ? "mm" : "°";
    axes += fmt::format("{}[\"{}\",\"{}\"]", axes.empty() ? "" : ",", arm::role_name(axis.role), unit);
  }
  return axes;
}

std::string refused_text(const PageRights& rights) {
  std::string items;
  for (const auto& [word, why] : rights.refused()) {
    items += fmt::format("{}{}:{}", items.empty() ? "" : ",", json_string(word), json_string(why));
  }
  return items;
}

}  // namespace

std::string hello_text(const CellView& cell, const PageHello& hello) {
  std::string arms;
  std::string axes;
  for (const auto& [arm, model] : cell.arms) {
    arms += (arms.empty() ? "" : ",") + json_string(arm);
    axes += fmt::format("{}{}:[{}]", axes.empty() ? "" : ",", json_string(arm), axes_text(model));
  }
  std::string reaches;
  for (const auto& [arm, reach] : cell.reaches) {
    reaches += fmt::format("{}{}:{}", reaches.empty() ? "" : ",", json_string(arm), reach_text(reach));
  }
  std::string camera = "null";
  if (cell.camera) {
    const forms::CameraPose& at = *cell.camera;
    camera = fmt::format("{{\"at\":[{:.2f},{:.2f},{:.2f}],\"pan\":{:.3f},\"tilt\":{:.3f},\"roll\":{:.3f},\"head\":{}}}",
                         at.at_mm[0], at.at_mm[1], at.at_mm[2], at.pan_deg, at.tilt_deg, at.roll_deg, cell.head);
  }
  return fmt::format(
      "{{\"hello\":{{\"version\":{},\"name\":{},\"cell\":{},\"arms\":[{}],\"axes\":{{{}}},\"reaches\":{{{}}},"
      "\"camera\":{},\"cube\":{:.1f},\"truth\":{},\"mayNot\":{{{}}},"
      "\"images\":{{\"path\":\"/socket/{}\",\"lanes\":{}}}}}}}",
      json_string(hello.version), json_string(hello.name), json_string(cell.name), arms, axes, reaches, camera,
      cell.cube_mm, hello.truth, refused_text(hello.rights), hello.page, PageImages::max_lanes);
}

}  // namespace pizarra::console
