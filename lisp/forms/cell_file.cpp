#include "lisp/forms/cell_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lisp/forms/arm_names.hpp"
#include "lisp/forms/file_paths.hpp"
#include "lisp/forms/named_parts.hpp"
#include "lisp/guile/scheme.hpp"
#include "lisp/nearest.hpp"

namespace pizarra::forms {

namespace {

// As (pizarra cell) tells them.
constexpr std::string_view parts_of_a_cell[] = {
    "name",        "camera",    "noise",    "cubes",      "arm",           "domain",   "board-host", "board-address",
    "hosts",       "cube-size", "openings", "row",        "board-keys",    "pan-tilt", "room",       "driver",
    "objects",     "eyes",      "slave",    "gripper",    "rate",          "agents",   "tags",       "door",
    "camera-pose", "lamp",      "tagged",   "background", "table-picture", "lens",     "bodies",     "things"};

std::vector<CellHost> hosts_from_datum(const Datum& hosts, const std::string& file) {
  std::vector<CellHost> out;
  for (const Datum& host : hosts.items()) {
    CellHost& added = out.emplace_back();
    added.name = host[0].text();
    added.key = beside(file, std::string(host[1].text()));
    for (const Datum& kind : host.items().subspan(2)) added.agents.emplace_back(kind.text());
  }
  return out;
}

PanTiltLine pan_tilt_from_datum(const Datum& datum) {
  PanTiltLine line{std::string(datum[0].text()), std::string(datum[1].text()), static_cast<int>(datum[2].integer())};
  for (const Datum& axis : datum[3].items()) {
    (axis.is_symbol("pan") ? line.pan_reversed : line.tilt_reversed) = true;
  }
  return line;
}

ArmLine arm_line_from_datum(const Datum& datum) {
  ArmLine line;
  if (datum.size() == 0) return line;
  line.protocol = datum[0].text();
  for (const Datum& place : datum[1].items()) line.places.emplace_back(place.text());
  for (const Datum& port : datum[2].items()) line.ports.push_back(static_cast<int>(port.integer()));
  return line;
}

GripperSetup gripper_from_datum(const Datum& datum) {
  GripperSetup gripper;
  if (datum.size() == 0) return gripper;
  gripper.protocol = datum[0].text();
  gripper.place = datum[1].text();
  gripper.port = static_cast<int>(datum[2].integer());
  gripper.unit = static_cast<int>(datum[3].integer());
  gripper.closed_mm = datum[4][0].number();
  gripper.open_mm = datum[4][1].number();
  gripper.closed_count = static_cast<int>(datum[5][0].integer());
  gripper.open_count = static_cast<int>(datum[5][1].integer());
  gripper.speed = datum[6].number() / 100;
  gripper.force = datum[7].number() / 100;
  RegisterField* const fields[] = {&gripper.activate,    &gripper.go,          &gripper.target,
                                   &gripper.speed_field, &gripper.force_field, &gripper.active,
                                   &gripper.object,      &gripper.fault,       &gripper.opening};
  for (std::size_t i = 0; i < std::size(fields); ++i) {
    const auto number = [&](std::size_t part) { return static_cast<int>(datum[8][i][part].integer()); };
    *fields[i] = {number(0), number(1), number(2)};
  }
  return gripper;
}

CameraSource camera_source_from_datum(const Datum& datum, const std::string& file) {
  using enum CameraSource::Kind;
  const std::string where(datum[1].text());
  if (datum[0].is_symbol("video")) return {video, beside(file, where)};
  if (datum[0].is_symbol("images")) return {images, beside(file, where)};
  if (datum[0].is_symbol("stream")) return {stream, where};
  if (datum[0].is_symbol("pipeline")) return {pipeline, where};
  return {device, where};
}

CameraSetup eyes_from_datum(const Datum& datum, const std::string& file) {
  using enum CameraSetup::Arrangement;
  if (datum.size() == 0) return {};
  CameraSetup eyes;
  if (datum[0].is_symbol("plugin")) {
    eyes.arrangement = plugin;
    eyes.plugin = datum[1][0][1].text();
    return eyes;
  }
  eyes.arrangement = datum[0].is_symbol("pair") ? pair : datum[0].is_symbol("single") ? single : side_by_side;
  for (const Datum& source : datum[1].items()) eyes.sources.push_back(camera_source_from_datum(source, file));
  eyes.width = static_cast<int>(datum[2][0].integer());
  eyes.height = static_cast<int>(datum[2][1].integer());
  eyes.rate_hz = datum[3].number();
  eyes.exposure_ms = datum[4].number();
  eyes.grey = datum[5].is_symbol("grey");
  eyes.skew_ms = datum[6].number();
  eyes.calibration_file = beside(file, std::string(datum[7].text()));
  eyes.focal_px = datum[8].number();
  eyes.base_line_mm = datum[9].number();
  eyes.learned_at_mm = datum[10].number();
  return eyes;
}

std::optional<CellRoom> room_from_datum(const Datum& room) {
  if (room.size() != 3) return std::nullopt;
  return CellRoom{{room[0][0].number(), room[1][0].number(), room[2][0].number()},
                  {room[0][1].number(), room[1][1].number(), room[2][1].number()}};
}

std::string arm_file_from_datum(const Datum& arm, const std::string& file) {
  return arm.is_string() ? beside(file, std::string(arm.text())) : shipped_arm_file(arm.text());
}

std::optional<CellSlave> slave_from_datum(const Datum& slave, const std::string& file) {
  if (slave.size() == 0) return std::nullopt;
  const Datum& offset = slave[3];
  ArmLine line = arm_line_from_datum(slave[2]);
  line.gripper = gripper_from_datum(slave[5]);
  return CellSlave{.arm_file = arm_file_from_datum(slave[0], file),
                   .room = room_from_datum(slave[1]),
                   .line = std::move(line),
                   .offset_mm = {offset[0].number(), offset[1].number(), offset[2].number()},
                   .mirrored = slave[4].is_symbol("mirror"),
                   .rate_hz = slave[6].number()};
}

std::vector<CellSchemeAgent> scheme_agents_from_datum(const Datum& agents, const std::string& file) {
  std::vector<CellSchemeAgent> out;
  for (const Datum& agent : agents.items()) {
    out.push_back({.name = std::string(agent[0].text()),
                   .file = beside(file, std::string(agent[1].text())),
                   .time_ms = static_cast<int>(agent[2].number()),
                   .memory_mb = static_cast<int>(agent[3].number()),
                   .messages_per_s = agent[4].number(),
                   .key = beside(file, std::string(agent[5].text()))});
  }
  return out;
}

std::vector<CellTags> tags_from_datum(const Datum& tags) {
  std::vector<CellTags> out;
  for (const Datum& each : tags.items()) out.push_back({std::string(each[0].text()), each[1].number()});
  return out;
}

std::vector<CellTagged> tagged_from_datum(const Datum& tagged) {
  std::vector<CellTagged> out;
  for (const Datum& each : tagged.items()) {
    out.push_back({std::string(each[0].text()), std::string(each[1].text()), static_cast<int>(each[2].integer()),
                   each[3].number()});
  }
  return out;
}

std::optional<CellLamp> lamp_from_datum(const Datum& lamp) {
  if (lamp.size() == 0) return std::nullopt;
  return CellLamp{{lamp[0].number(), lamp[1].number(), lamp[2].number()}, lamp[3].number()};
}

std::optional<CellPicture> picture_from_datum(const Datum& picture, const Source& source) {
  if (picture.size() == 0) return std::nullopt;
  std::vector<std::size_t> path;
  for (const Datum& index : picture[1].items()) path.push_back(static_cast<std::size_t>(index.integer()));
  return CellPicture{beside(source.file(), std::string(picture[0].text())), source.failure_at(path, "", "").place};
}

std::optional<CellDoor> door_from_datum(const Datum& datum, const std::string& file) {
  if (datum.size() == 0) return std::nullopt;
  CellDoor door;
  if (datum[0].integer() >= 0) door.tcp_port = static_cast<int>(datum[0].integer());
  for (const Datum& line : datum[1].items()) {
    door.lines.push_back({std::string(line[0].text()), static_cast<int>(line[1].integer())});
  }
  door.keys = beside(file, std::string(datum[2].text()));
  return door;
}

std::array<double, 3> three_from_datum(const Datum& datum) {
  return {datum[0].number(), datum[1].number(), datum[2].number()};
}

std::optional<HeadAxes> axes_from_datum(const Datum& datum) {
  if (datum.items().empty()) return std::nullopt;
  return HeadAxes{.pan = {three_from_datum(datum[0]), three_from_datum(datum[1])},
                  .tilt = {three_from_datum(datum[2]), three_from_datum(datum[3])}};
}

CameraPose camera_pose_from_datum(const Datum& datum, const Datum& axes) {
  return {.at_mm = {datum[0].number(), datum[1].number(), datum[2].number()},
          .pan_deg = datum[3].number(),
          .tilt_deg = datum[4].number(),
          .roll_deg = datum[5].number(),
          .axes = axes_from_datum(axes)};
}

BelievedCamera believed_camera_from_datum(const Datum& datum) {
  const bool unknown = datum[0].items().empty();
  return {.pose = unknown ? CameraPose() : camera_pose_from_datum(datum[0], datum[4]),
          .unknown = unknown,
          .sure_mm = datum[1][0].number(),
          .sure_deg = datum[1][1].number(),
          .mark_mm = three_from_datum(datum[2])};
}

// The file counts as soon as there is one.
Result<BelievedCamera> believed_camera(const Datum& datum, const std::string& cell_file) {
  const BelievedCamera guessed = believed_camera_from_datum(datum);
  const std::string file = beside(cell_file, std::string(datum[3].text()));
  if (file.empty() || !std::filesystem::exists(file)) return guessed;
  const Result<Source> source = read_source_file(file);
  if (!source) return fail(source);
  const Result<Datum> measured = guile::interpret(*source, "camera-pose");
  if (!measured) return fail(measured);
  return believed_camera_from_datum(*measured);
}

std::vector<std::pair<std::string, std::string>> faces_from(std::span<const Datum> faces) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const Datum& face : faces) out.emplace_back(face[0].text(), face[1].text());
  return out;
}

ThingPlacement thing_from_datum(const Datum& thing) {
  return {std::string(thing[0].text()),
          thing[1].is_symbol("cylinder"),
          {thing[2].number(), thing[3].number(), thing[4].number()},
          thing[5].number(),
          thing[6].number(),
          thing[7].number()};
}

CellDescription cell_from_parts(const NamedParts& parts, const std::string& file) {
  CellDescription cell;
  cell.name = parts.at("name").text();
  const Datum& camera = parts.at("camera");
  cell.world_camera = camera_pose_from_datum(camera, camera[9]);
  cell.head = camera[6].text();
  cell.frames_per_s = static_cast<int>(camera[7].integer());
  cell.image = {static_cast<int>(camera[8][0].integer()), static_cast<int>(camera[8][1].integer())};
  const Datum& noise = parts.at("noise");
  cell.noise = {noise[0].number(), noise[1].number(), noise[2].number()};
  for (const Datum& cube : parts.at("cubes").items()) cell.cubes.push_back(cube_from_datum(cube));
  const Datum& arm = parts.at("arm");
  cell.arm_file = arm_file_from_datum(arm, file);
  cell.arm = arm.is_string() ? std::filesystem::path(cell.arm_file).stem().string() : arm.text();
  cell.domain_file = beside(file, std::string(parts.at("domain").text()));
  cell.board_host = parts.at("board-host").text();
  cell.board_address = parts.at("board-address").text();
  cell.hosts = hosts_from_datum(parts.at("hosts"), file);
  cell.cube_mm = parts.at("cube-size").number();
  const Datum& openings = parts.at("openings");
  cell.openings = {openings[0].number(), openings[1].number(), openings[2].number()};
  const Datum& row = parts.at("row");
  cell.row = {row[0].number(), row[1].number(), row[2].number()};
  cell.board_keys = beside(file, std::string(parts.at("board-keys").text()));
  cell.pan_tilt = pan_tilt_from_datum(parts.at("pan-tilt"));
  cell.arm_room = room_from_datum(parts.at("room"));
  cell.arm_line = arm_line_from_datum(parts.at("driver"));
  cell.arm_line.gripper = gripper_from_datum(parts.at("gripper"));
  cell.objects_directory = beside(file, std::string(parts.at("objects").text()));
  cell.eyes = eyes_from_datum(parts.at("eyes"), file);
  cell.slave = slave_from_datum(parts.at("slave"), file);
  cell.arm_rate_hz = parts.at("rate").number();
  cell.scheme_agents = scheme_agents_from_datum(parts.at("agents"), file);
  cell.tags = tags_from_datum(parts.at("tags"));
  cell.door = door_from_datum(parts.at("door"), file);
  cell.second_lamp = lamp_from_datum(parts.at("lamp"));
  for (const Datum& thing : parts.at("things").items()) cell.things.push_back(thing_from_datum(thing));
  cell.tagged = tagged_from_datum(parts.at("tagged"));
  for (const Datum& body : parts.at("bodies").items()) {
    const auto marks = body.items().subspan(1);
    cell.bodies.push_back({std::string(body[0].text()), Datum::list({marks.begin(), marks.end()})});
  }
  return cell;
}

Result<CellDescription> interpret_cell(const Result<Source>& source) {
  if (!source) return fail(source);
  std::vector<Datum> arms;
  for (const std::string& name : arm_names()) arms.push_back(Datum::symbol(name));
  const Result<Datum> interpreted = guile::interpret(*source, "cell", {Datum::list(std::move(arms))});
  if (!interpreted) return fail(interpreted);
  const Result<NamedParts> cell = NamedParts::of(*interpreted, "cell", parts_of_a_cell);
  if (!cell) return fail(cell);
  CellDescription described = cell_from_parts(*cell, source->file());
  const Result<BelievedCamera> camera = believed_camera(cell->at("camera-pose"), source->file());
  if (!camera) return fail(camera);
  described.camera = *camera;
  described.background = picture_from_datum(cell->at("background"), *source);
  for (std::size_t i = 0; i < described.lens.size(); ++i) described.lens[i] = cell->at("lens")[i].number();
  described.table_picture = picture_from_datum(cell->at("table-picture"), *source);
  described.camera_pose_file = beside(source->file(), std::string(cell->at("camera-pose")[3].text()));
  return described;
}

}  // namespace

const CellSchemeAgent* scheme_agent_called(const CellDescription& cell, std::string_view name) {
  const auto found = std::ranges::find(cell.scheme_agents, name, &CellSchemeAgent::name);
  return found == cell.scheme_agents.end() ? nullptr : &*found;
}

EdgesMm CellDescription::edges_mm() const {
  EdgesMm edges;
  for (const CubePlacement& cube : cubes) edges.emplace(cube.name, cube.edge_mm);
  return edges;
}

CubePlacement cube_from_datum(const Datum& normalised) {
  return {std::string(normalised[0].text()),
          std::string(normalised[1].text()),
          normalised[2].number(),
          normalised[3].number(),
          normalised[4].number(),
          std::string(normalised[5].text()),
          normalised[6].number(),
          faces_from(normalised.items().subspan(7))};
}

Result<CellDescription> read_cell(std::string_view text, const std::string& file) {
  return interpret_cell(read_source(text, file));
}

Result<CellDescription> read_cell_file(const std::string& path) { return interpret_cell(read_source_file(path)); }

Result<void> put_arm(CellDescription& cell, const std::string& arm) {
  const std::string shipped = arm_called(arm);
  if (shipped.empty() && !std::filesystem::is_regular_file(arm)) {
    const std::string nearest = nearest_name(arm, arm_names());
    return fail(
        "unknown-arm",
        fmt::format("there is no arm \"{}\" and no such arm file; there are {}{}", arm, fmt::join(arm_names(), ", "),
                    nearest.empty() ? "" : fmt::format(": did you mean {}?", nearest)),
        Datum::string(arm));
  }
  cell.arm_file = shipped.empty() ? arm : shipped_arm_file(shipped);
  cell.arm = shipped.empty() ? std::filesystem::path(arm).stem().string() : shipped;
  // The other arm's controller is not its own.
  cell.arm_line = {};
  return {};
}

}  // namespace pizarra::forms
