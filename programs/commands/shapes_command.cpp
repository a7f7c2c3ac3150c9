// `shapes`: something to show to the eyes, from a printer.

#include <filesystem>
#include <fmt/format.h>

#include "lisp/outside_text.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/print_sheet.hpp"

namespace pizarra::programs {
namespace {

struct ShapesChoices {
  std::string file;
  bool board = false;
};

int print_shapes(const ShapesChoices& choices) {
  const std::filesystem::path folder = std::filesystem::path(choices.file).parent_path();
  const bool new_folder = !folder.empty() && !std::filesystem::exists(folder);
  const Result<void> written = write_sheet(choices.file, choices.board ? board_sheet() : shapes_sheet());
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
      "Make a sheet to print, for trying the eyes on a camera of your own: the four shapes, as faces for cubes.");
  shapes->add_option("--print", choices->file, "Write the page here")->required()->type_name("FILE.pdf|FILE.png");
  shapes->add_flag("--board", choices->board, "Instead: the chessboard that `calibrate` looks for");
  shapes->footer(help_footer("shapes --print shapes.pdf"));
  shapes->callback([choices, &status] { status = print_shapes(*choices); });
}

}  // namespace pizarra::programs
