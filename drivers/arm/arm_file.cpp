#include "drivers/arm/arm_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/kinematics.hpp"
#include "lisp/forms/arm_names.hpp"
#include "lisp/guile/scheme.hpp"
#include "lisp/nearest.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::arm {

namespace {

Build build_from(const Datum& name) {
  if (name.is_symbol("polar")) return Build::polar;
  if (name.is_symbol("scara")) return Build::scara;
  if (name.is_symbol("gantry")) return Build::gantry;
  return Build::articulated;
}

Role role_from(const Datum& name) {
  constexpr Role roles[] = {Role::turn, Role::shoulder, Role::elbow, Role::reach, Role::ahead, Role::across,
                            Role::lift, Role::roll,     Role::pitch, Role::spin,  Role::track};
  return *std::ranges::find(roles, name.text(), role_name);
}

Axis axis_from(const Datum& given) {
  Axis axis{.role = role_from(given[0]),
            .limits = {given[1].number(), given[2].number()},
            .speed = given[3].number(),
            .sense = given[4].number(),
            .zero = given[5].number(),
            .from_base = given[6].is_symbol("base"),
            .stops = {},
            .pulses_per_turn = given[8].number()};
  if (given[7].size() == 2) axis.stops = Range{given[7][0].number(), given[7][1].number()};
  return axis;
}

Joints joints_from(const Datum& given) {
  Joints joints(given.size());
  std::ranges::transform(given.items(), joints.begin(), &Datum::number);
  return joints;
}

ArmModel model_from(const Datum& arm) {
  const Datum& sizes = arm[2];
  ArmModel model{.type = std::string(arm[0].text()),
                 .build = build_from(arm[1]),
                 .height_mm = sizes[0].number(),
                 .offset_mm = sizes[1].number(),
                 .side_mm = sizes[7].number(),
                 .upper_arm_mm = sizes[2].number(),
                 .forearm_mm = sizes[3].number(),
                 .forearm_raise_mm = sizes[4].number(),
                 .wrist_mm = sizes[5].number(),
                 .wrist_across_mm = sizes[8].number(),
                 .tool_mm = sizes[6].number(),
                 .axes = {},
                 .track_along_x = false,
                 .home = joints_from(arm[4]),
                 .ready = joints_from(arm[5])};
  for (const Datum& axis : arm[3].items()) {
    model.axes.push_back(axis_from(axis));
    if (model.axes.back().role == Role::track) model.track_along_x = axis[9].is_symbol("x");
  }
  return model;
}

// Where the arm's form holds the pose `name`.
std::vector<std::size_t> path_to(const Source& source, std::string_view name) {
  const auto sections = source.data().front().items();
  const auto pose = std::ranges::find_if(sections, [name](const Datum& section) { return section.head() == name; });
  return {0, static_cast<std::size_t>(pose - sections.begin())};
}

// Work begins and ends with the tool down.
Result<void> check_pose(const Source& source, const ArmModel& model, std::string_view name, const Joints& pose) {
  constexpr double slack_deg = 0.5;
  const double down = -forward(model, pose).linear()(2, 2);
  const double tilt_deg = degrees(std::acos(std::clamp(down, -1.0, 1.0)));
  if (tilt_deg <= slack_deg) return {};
  const std::string sentence = fmt::format("the tool points down there, and here it leans by {:.1f} degrees", tilt_deg);
  return fail(source.failure_at(path_to(source, name), "malformed", sentence, {"in arm " + model.type}));
}

}  // namespace

Result<ArmModel> read_arm_file(const std::string& path) {
  const Result<Source> source = read_source_file(path);
  if (!source) return fail(source);
  const Result<Datum> arm = guile::interpret(*source, "arm");
  if (!arm) return fail(arm);
  ArmModel model = model_from(*arm);
  for (const auto& [name, pose] : {std::pair("home", &model.home), std::pair("ready", &model.ready)}) {
    const Result<void> sound = check_pose(*source, model, name, *pose);
    if (!sound) return fail(sound);
  }
  return model;
}

Result<ArmModel> shipped_arm(std::string_view name) {
  const std::vector<std::string> names = forms::arm_names();
  if (std::ranges::find(names, name) != names.end()) return read_arm_file(forms::shipped_arm_file(name));
  const std::string nearest = nearest_name(name, names);
  return fail(
      "unknown-arm",
      fmt::format("no arm is called {}{}", name, nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
      Datum::symbol(name));
}

const ArmModel& crs_f3() {
  static const ArmModel model = shipped_arm("crs-f3").value();
  return model;
}

}  // namespace pizarra::arm
