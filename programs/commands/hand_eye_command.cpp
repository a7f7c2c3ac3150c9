// `calibrate hand-eye`: where a cell's camera stands, from what it sees of the mark that the arm carries.

#include <fmt/format.h>

#include "blackboard/client/keyed_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "drivers/arm/arm_file.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/command_line/key_option.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/hand_eye/hand_eye.hpp"
#include "programs/story/output_file.hpp"

namespace pizarra::programs {

namespace {

struct HandEyeChoices {
  std::string cell;
  std::string out;
  std::string running;  // the name of a cell that runs here
  std::string key;
  std::size_t poses = 28;
  std::uint64_t seed = 1;
  bool json = false;
};

repl::Style style_of(const HandEyeChoices& choices) { return choices.json ? repl::Style::json : repl::Style::text; }

void print_line(const HandEyeChoices& choices, const std::string& line) {
  if (choices.json) {
    fmt::print("{{\"step\":{}}}\n", json_string(line));
  } else {
    fmt::print("{}\n", line);
  }
  std::fflush(stdout);
}

Task<void> keep(Task<Result<hand_eye::HandEyeResult>> finding, Result<hand_eye::HandEyeResult>& found) {
  found = co_await std::move(finding);
}

Result<hand_eye::HandEyeResult> finished(Executor& executor, Task<Result<hand_eye::HandEyeResult>> finding) {
  Result<hand_eye::HandEyeResult> found = fail("interrupted", "the calibration did not end");
  const Job job = executor.spawn(keep(std::move(finding), found));
  executor.run_until([&job] { return job.done(); });
  return found;
}

// The cell's own arm and eyes, where both are simulated: in virtual time, in this process.
Result<hand_eye::HandEyeResult> find_in_simulation(const HandEyeChoices& choices, forms::CellDescription description,
                                                   const arm::ArmModel& arm, const hand_eye::HandEye::Tell& tell) {
  description.objects_directory.clear();
  const Result<simulation::WorldConfig> config = launcher::world_config(description, choices.seed);
  if (!config) return fail(config);
  VirtualExecutor executor;
  launcher::LocalCell cell(executor, description, choices.seed);
  const std::unique_ptr<Board> board = cell.board().view("hand-eye");
  hand_eye::HandEye hand_eye(executor, *board, cell.description(), arm, choices.poses, tell);
  return finished(executor, hand_eye::find_in_local_cell(cell, *board, hand_eye));
}

Result<hand_eye::HandEyeResult> find_in_running_cell(const HandEyeChoices& choices,
                                                     const forms::CellDescription& description,
                                                     const arm::ArmModel& arm, const hand_eye::HandEye::Tell& tell) {
  const Result<Destination> to = destination({.board = {}, .cell = choices.running, .key = choices.key});
  if (!to) return fail(to);
  RealExecutor executor;
  const auto board = client::keyed_board(executor, to->address, to->key, "hand-eye");
  if (!board) return fail(board);
  hand_eye::HandEye hand_eye(executor, **board, description, arm, choices.poses, tell);
  return finished(executor, hand_eye.run());
}

std::string axis_json(const forms::HeadAxis& axis) {
  return fmt::format("{{\"at_mm\":[{:.3f},{:.3f},{:.3f}],\"along\":[{:.5f},{:.5f},{:.5f}]}}", axis.at_mm[0],
                     axis.at_mm[1], axis.at_mm[2], axis.along[0], axis.along[1], axis.along[2]);
}

std::string axis_words(const forms::HeadAxis& axis) {
  return fmt::format("through ({:.2f} {:.2f} {:.2f}) along ({:.4f} {:.4f} {:.4f})", axis.at_mm[0], axis.at_mm[1],
                     axis.at_mm[2], axis.along[0], axis.along[1], axis.along[2]);
}

void print_head(const HandEyeChoices& choices, const hand_eye::HandEyeResult& found) {
  const hand_eye::HandEyeResult::Head& head = *found.head;
  const forms::HeadAxes& axes = *found.camera.pose.axes;
  if (choices.json) {
    fmt::print(
        "{{\"pan_axis\":{},\"tilt_axis\":{},\"sure_mm\":{:.3f},\"sure_deg\":{:.4f},\"angles\":{},\"checked_mm\":{:.3f}}"
        "}\n",
        axis_json(axes.pan), axis_json(axes.tilt), head.sure_mm, head.sure_deg, head.angles, head.checked_mm);
    return;
  }
  fmt::print("{} angles of the head; at {} held back the mark is placed {:.2f} mm off\n", head.angles, head.held_back,
             head.checked_mm);
  fmt::print(
      "in the camera's frame it pans about an axis {},\nand tilts about one {}; standard deviations {:.2f} mm, {:.3f} "
      "degrees\n",
      axis_words(axes.pan), axis_words(axes.tilt), head.sure_mm, head.sure_deg);
}

void print_result(const HandEyeChoices& choices, const hand_eye::HandEyeResult& found) {
  const forms::CameraPose& pose = found.camera.pose;
  if (choices.json) {
    fmt::print(
        "{{\"x_mm\":{:.3f},\"y_mm\":{:.3f},\"z_mm\":{:.3f},\"pan_deg\":{:.4f},\"tilt_deg\":{:.4f},\"roll_deg\":{:.4f},"
        "\"sure_mm\":{:.3f},\"sure_deg\":{:.4f},\"poses\":{},\"error_px\":{:.3f},\"checked_mm\":{:.3f}}}\n",
        pose.at_mm[0], pose.at_mm[1], pose.at_mm[2], pose.pan_deg, pose.tilt_deg, pose.roll_deg, found.camera.sure_mm,
        found.camera.sure_deg, found.poses, found.error_px, found.checked_mm);
    return;
  }
  fmt::print("{} poses, {:.2f} px off; at {} held back the mark is placed {:.2f} mm off\n", found.poses, found.error_px,
             found.held_back, found.checked_mm);
  fmt::print(
      "the camera stands at ({:.2f} {:.2f} {:.2f}), pan {:.3f}, tilt {:.3f}, roll {:.3f}; standard deviations {:.2f} "
      "mm, {:.3f} degrees\n",
      pose.at_mm[0], pose.at_mm[1], pose.at_mm[2], pose.pan_deg, pose.tilt_deg, pose.roll_deg, found.camera.sure_mm,
      found.camera.sure_deg);
}

int keep_result(const HandEyeChoices& choices, const forms::CellDescription& cell,
                const hand_eye::HandEyeResult& found) {
  const std::string out = choices.out.empty() ? cell.camera_pose_file : choices.out;
  const std::string text = hand_eye::write_believed_camera(found.camera);
  if (out.empty()) {
    print_line(choices, "in the cell file: " + text.substr(0, text.size() - 1));
    return exit_reached;
  }
  const Result<void> written =
      story::write_file(out, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (!written) return complain_as(style_of(choices), written.error(), exit_unavailable);
  print_line(choices, fmt::format("{} written", text_of_bytes(out)));
  return exit_reached;
}

int run_hand_eye(const HandEyeChoices& choices) {
  const Result<forms::CellDescription> cell = forms::read_cell_file(choices.cell);
  if (!cell) return complain_as(style_of(choices), cell.error(), exit_usage);
  const Result<arm::ArmModel> arm = arm::read_arm_file(cell->arm_file);
  if (!arm) return complain_as(style_of(choices), arm.error(), exit_usage);
  const hand_eye::HandEye::Tell tell = [&choices](const std::string& line) { print_line(choices, line); };
  const bool simulated = cell->arm_line.protocol.empty() && cell->eyes.is_simulated() && choices.running.empty();
  const Result<hand_eye::HandEyeResult> found =
      simulated ? find_in_simulation(choices, *cell, *arm, tell) : find_in_running_cell(choices, *cell, *arm, tell);
  if (!found) return complain_as(style_of(choices), found.error(), exit_failed);
  print_result(choices, *found);
  if (found->head) print_head(choices, *found);
  return keep_result(choices, *cell, *found);
}

}  // namespace

void add_hand_eye_command(CLI::App& calibrate, int& status) {
  auto choices = std::make_shared<HandEyeChoices>();
  CLI::App* word = calibrate.add_subcommand(
      "hand-eye",
      "Find out where a cell's camera stands: the arm carries its mark to poses before it. A camera on a pan-tilt unit "
      "is\nalso turned, which tells about which axes. A cell whose arm and eyes are simulated is played here; another "
      "one "
      "must\nrun, with nothing high on its table.");
  word->add_option("CELL", choices->cell, "The cell file")->required()->check(CLI::ExistingFile);
  word->add_option(
      "--out", choices->out,
      "The file to write; default: the one of the cell's (camera-pose ... (file ...)). Without any the result "
      "is only printed");
  word->add_option("--poses", choices->poses, "To how many poses the mark is carried")
      ->check(CLI::Range(10, 200))
      ->capture_default_str();
  word->add_option("--cell", choices->running, "The name of the running cell, where several run here");
  add_key_option(word, choices->key);
  word->add_option("--seed", choices->seed, "Of the simulated noise")->check(seed_check())->capture_default_str();
  word->add_flag("--json", choices->json, "Print one JSON object a line");
  word->footer(help_footer("calibrate hand-eye examples/01-blocks/cell.scm"));
  word->callback([choices, &status] { status = run_hand_eye(*choices); });
}

}  // namespace pizarra::programs
