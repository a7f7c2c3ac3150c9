#include "programs/chaos/draw_scenery.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>

#include "lisp/shipped.hpp"

namespace pizarra::chaos {

namespace {

constexpr std::uint64_t one_in = 8;  // cells has a lamp, and as many have each of the others
// They come with the programs.
constexpr std::array<std::string_view, 2> pictures = {"examples/19-scenery/wall.png", "examples/19-scenery/table.png"};

bool bends(const forms::CellDescription& cell) { return cell.lens != std::array<double, 5>{}; }

// On the cameras' side: from behind it leaves the marks in the dark. Where it gave more of the light, the shadow of a
// finger would hide a mark from the eyes.
forms::CellLamp draw_lamp(Random random) {
  return {.at_mm = {random.uniform(900, 1400), random.uniform(-1200, 1200), random.uniform(900, 2000)},
          .part = random.uniform(0.1, 0.2)};
}

// From a barrel to a slight cushion, and a little out of square.
std::array<double, 5> draw_lens(Random random) {
  return {random.uniform(-0.3, 0.1), random.uniform(0, 0.1), random.uniform(-0.002, 0.002),
          random.uniform(-0.002, 0.002), 0};
}

forms::CellPicture draw_picture(Random random) {
  return {.file = shipped_file(pictures[random.below(pictures.size())]), .named_at = {}};
}

std::string picture_text(std::string_view where, const forms::CellPicture& picture) {
  return fmt::format("a photograph {}: {}", where, std::filesystem::path(picture.file).filename().string());
}

}  // namespace

// Each from a stream of its own: whether a cell has one does not change another.
void draw_scenery(forms::CellDescription& cell, const Random& random) {
  const auto has = [&](std::string_view thing) { return random.split(thing).below(one_in) == 0; };
  if (has("lamp") && !cell.second_lamp) cell.second_lamp = draw_lamp(random.split("where the lamp is"));
  if (has("lens") && !bends(cell)) cell.lens = draw_lens(random.split("which lens"));
  if (has("wall") && !cell.background) cell.background = draw_picture(random.split("which wall"));
  if (has("table") && !cell.table_picture) cell.table_picture = draw_picture(random.split("which table"));
}

std::vector<std::string> describe_scenery(const forms::CellDescription& cell) {
  std::vector<std::string> lines;
  if (cell.second_lamp) {
    const auto& [at_mm, part] = *cell.second_lamp;
    lines.push_back(
        fmt::format("a lamp at {:.0f} {:.0f} {:.0f} gives {:.2f} of the light", at_mm[0], at_mm[1], at_mm[2], part));
  }
  if (bends(cell)) {
    const auto& [k1, k2, p1, p2, k3] = cell.lens;
    lines.push_back(
        fmt::format("lenses with k1 {:.3f}, k2 {:.3f}, p1 {:.4f}, p2 {:.4f}, k3 {:.3f}", k1, k2, p1, p2, k3));
  }
  if (cell.background) lines.push_back(picture_text("behind the table", *cell.background));
  if (cell.table_picture) lines.push_back(picture_text("on the table", *cell.table_picture));
  return lines;
}

}  // namespace pizarra::chaos
