#include "programs/chaos/draw_marks.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <numeric>

#include "drivers/simulation/face_mark.hpp"
#include "programs/chaos/draw_camera.hpp"
#include "programs/chaos/draw_cubes.hpp"

namespace pizarra::chaos {

namespace {

constexpr std::uint64_t marked_in = 8;  // cells has tagged cubes, and as many have bodies
constexpr std::uint64_t most_bodies = 3;
// Each with as many tags as a cell may need.
constexpr std::array<std::string_view, 5> families = {"apriltag-36h11", "apriltag-25h9", "apriltag-16h5",
                                                      "aruco-4x4-50", "aruco-5x5-50"};
constexpr int tags_of_each_family = 30;

// Where the simulated world has each face: from the middle, in half edges, and how it is turned, degrees.
struct Side {
  const char* face;
  std::array<int, 3> at;
  std::array<int, 3> turned;
};
constexpr std::array<Side, 6> sides = {{{"front", {0, 0, -1}, {0, 0, 0}},
                                        {"right", {1, 0, 0}, {0, -90, 0}},
                                        {"back", {0, 0, 1}, {0, 180, 0}},
                                        {"left", {-1, 0, 0}, {0, 90, 0}},
                                        {"top", {0, -1, 0}, {-90, 0, 0}},
                                        {"bottom", {0, 1, 0}, {90, 180, 0}}}};

// Gives tags to cubes, no tag twice.
class Tagging {
 public:
  Tagging(forms::CellDescription& cell, Random random) : cell_(cell), family_(families[random.below(families.size())]) {
    const int needed = static_cast<int>(cell.cubes.size() + most_bodies * sides.size());
    next_ = static_cast<int>(random.below(static_cast<std::uint64_t>(tags_of_each_family - needed) + 1));
  }

  void wear_one(forms::CubePlacement& cube) {
    const int number = next_++;
    cube.name = fmt::format("tag-{}", number);
    cube.mark = fmt::format("{}-{}", family_, number);
    know(cube.name, number, cube);
  }

  void wear_one_on_each_face(forms::CubePlacement& cube) {
    cube.name = fmt::format("box-{}", next_);
    cube.mark = fmt::format("{}-{}", family_, next_);
    std::vector<Datum> marks;
    for (const Side& side : sides) {
      const int number = next_++;
      const std::string name = fmt::format("{}-{}", cube.name, side.face);
      cube.faces.emplace_back(side.face, fmt::format("{}-{}", family_, number));
      know(name, number, cube);
      marks.push_back(list(Datum::string(name), place_of(side, cube.edge_mm / 2), turn_of(side)));
    }
    cell_.bodies.push_back({cube.name, Datum::list(std::move(marks))});
  }

 private:
  void know(const std::string& name, int number, const forms::CubePlacement& cube) {
    cell_.tagged.push_back({name, std::string(family_), number, simulation::tag_part_of_edge * cube.edge_mm});
  }
  static Datum place_of(const Side& side, double half_mm) {
    return list(side.at[0] * half_mm, side.at[1] * half_mm, side.at[2] * half_mm);
  }
  static Datum turn_of(const Side& side) { return list(side.turned[0], side.turned[1], side.turned[2]); }

  forms::CellDescription& cell_;
  const std::string_view family_;
  int next_ = 0;
};

// The places of the cubes, in any order.
std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), 0);
  for (std::size_t left = count; left > 1; --left) std::swap(places[left - 1], places[random.below(left)]);
  return places;
}

bool is_one_on_all_faces(const forms::CellDescription& cell, const forms::CellTagged& tagged) {
  return std::ranges::find(cell.cubes, tagged.name, &forms::CubePlacement::name) != cell.cubes.end();
}

}  // namespace

void draw_marks(forms::CellDescription& cell, const Random& random) {
  if (has_tags_of_its_own(cell)) return take_larger_images(cell);
  if (has_many_cubes(cell)) return;
  const bool with_bodies = random.split("bodies").below(marked_in) == 0;
  const bool with_tags = random.split("tags").below(marked_in) == 0;
  if (!with_bodies && !with_tags) return;
  take_larger_images(cell);
  Random which = random.split("which");
  Tagging tagging(cell, random.split("family"));
  std::vector<std::size_t> plain = shuffled(cell.cubes.size(), which);
  const auto take = [&] {
    forms::CubePlacement& cube = cell.cubes[plain.back()];
    plain.pop_back();
    return &cube;
  };
  const std::uint64_t bodies =
      with_bodies ? 1 + which.below(std::min<std::uint64_t>(most_bodies, plain.size() - 1)) : 0;
  for (std::uint64_t n = 0; n < bodies; ++n) tagging.wear_one_on_each_face(*take());
  const std::uint64_t tags = with_tags ? 1 + which.below(plain.size()) : 0;
  for (std::uint64_t n = 0; n < tags; ++n) tagging.wear_one(*take());
}

std::vector<std::string> describe_marks(const forms::CellDescription& cell) {
  std::vector<std::string> lines;
  for (const forms::CellTagged& tagged : cell.tagged) {
    lines.push_back(fmt::format("{} wears {}-{}", tagged.name, tagged.family, tagged.number));
  }
  return lines;
}

bool has_tagged_cubes(const forms::CellDescription& cell) {
  return std::ranges::any_of(cell.tagged, [&](const auto& tagged) { return is_one_on_all_faces(cell, tagged); });
}

bool has_bodies(const forms::CellDescription& cell) { return !cell.bodies.empty(); }

}  // namespace pizarra::chaos
