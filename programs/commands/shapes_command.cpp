// `shapes`: something to show to the eyes, from a printer.

#include <filesystem>
#include <fmt/format.h>
#include <optional>

#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/print_sheet.hpp"

namespace pizarra::programs {
namespace {

struct ShapesChoices {
  std::string file;
  bool board = false;
  bool charuco = false;
  std::string tags;
  std::optional<double> side_mm;
};

Result<Sheet> sheet_of(const ShapesChoices& choices) {
  if (!choices.tags.empty()) return tags_sheet(choices.tags, choices.side_mm);
  if (choices.charuco) return charuco_sheet();
  return choices.board ? board_sheet() : shapes_sheet();
}

int print_shapes(const ShapesChoices& choices) {
  const std::filesystem::path folder = std::filesystem::path(choices.file).parent_path();
  const bool new_folder = !folder.empty() && !std::filesystem::exists(folder);
  const Result<Sheet> sheet = sheet_of(choices);
  if (!sheet) return complain(sheet.error(), exit_usage);
  const Result<void> written = write_sheet(choices.file, *sheet);
  if (!written)
    return complain(written.error(), written.error().symbol == "cannot-write" ? exit_unavailable : exit_usage);
  fmt::print("{}: an A4 page{}; print it at 100 %, and measure its bar of 100 mm\n", text_of_bytes(choices.file),
             new_folder ? " in a new folder" : "");
  return exit_reached;
}

}  // namespace

void add_shapes_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<ShapesChoices>();
  CLI::App* shapes = app.add_subcommand(
      "shapes",
      "Make a sheet to print, for trying the eyes on a camera of your own: the four shapes, as faces\n"
      "for cubes, a board of `calibrate`, or tags.");
  shapes->add_option("--print", choices->file, "Write the page to this file")
      ->required()
      ->type_name("FILE.pdf|FILE.png");
  CLI::Option* const board =
      shapes->add_flag("--board", choices->board, "Instead: the chessboard that `calibrate` looks for");
  CLI::Option* const charuco =
      shapes->add_flag("--charuco", choices->charuco, "Instead: the ChArUco board that `calibrate --charuco` looks for")
          ->excludes(board);
  CLI::Option* const tags =
      shapes->add_option("--tags", choices->tags, "Instead: these tags of one family, such as 36h11:0-11 or 4x4-50:3,7")
          ->type_name("FAMILY:IDS")
          ->excludes(board)
          ->excludes(charuco);
  shapes
      ->add_option("--side", choices->side_mm,
                   "The side of the tags' square, mm; default 40, and 25 of the light square of 41h12, 21h7 and 52h13")
      ->check(number_check(2, 200))
      ->needs(tags);
  shapes->footer(help_footer("shapes --print shapes.pdf"));
  shapes->callback([choices, &status] { status = print_shapes(*choices); });
}

}  // namespace pizarra::programs
