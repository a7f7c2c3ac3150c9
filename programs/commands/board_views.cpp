#include "programs/commands/board_views.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace pizarra::programs {
namespace {

constexpr std::size_t most_sizes = 8;

// As many corners say where a flat board stands, whatever else of it is seen.
constexpr std::size_t corners_of_a_place = 4;

bool is_near(const cv::Point2f& a, const cv::Point2f& b, double reach_px) { return cv::norm(a - b) <= reach_px; }

// Where which of the board's corners a view has, that is known; else it has all of them.
std::size_t number_of(const camera::BoardView& view, std::size_t i) { return view.which.empty() ? i : view.which[i]; }

// Whether the board stands the same in both, as far as both see it.
bool is_same(const camera::BoardView& a, const camera::BoardView& b, double reach_px) {
  std::size_t common = 0;
  for (std::size_t i = 0, j = 0; i < a.left.size() && j < b.left.size();) {
    const std::size_t in_a = number_of(a, i);
    const std::size_t in_b = number_of(b, j);
    if (in_a == in_b) {
      if (!is_near(a.left[i], b.left[j], reach_px)) return false;
      if (!a.right.empty() && !is_near(a.right[i], b.right[j], reach_px)) return false;
      ++common;
    }
    if (in_a <= in_b) ++i;
    if (in_b <= in_a) ++j;
  }
  return common >= corners_of_a_place;
}

}  // namespace

Result<void> BoardViews::take(const ImagePair& pair, const std::string& name) {
  newest_.reset();
  const cv::Size size = pair.left.size();
  if (!pair.right.empty() && pair.right.size() != size) {
    return fail("wrong-size",
                fmt::format("images of {}x{} and {}x{}", size.width, size.height, pair.right.cols, pair.right.rows));
  }
  Result<camera::BoardView> view = camera::find_board(pair.left, pair.right, board_);
  if (!view) return fail(view);
  newest_ = *view;
  const Result<OneSize*> alike = with_size(size);
  if (!alike) return fail(alike);
  const double reach_px = least_motion_ * size.width;
  for (const camera::BoardView& before : (*alike)->views) {
    if (!is_same(before, *view, reach_px)) continue;
    return fail("still", fmt::format("the board stands as in {}", before.name));
  }
  view->name = name;
  (*alike)->views.push_back(std::move(*view));
  return {};
}

Result<BoardViews::OneSize*> BoardViews::with_size(cv::Size size) {
  const auto found = std::ranges::find(sizes_, size, &OneSize::size);
  if (found != sizes_.end()) return &*found;
  if (sizes_.size() == most_sizes) {
    return fail("wrong-size", fmt::format("an image of {}x{}, and there are {} other sizes already", size.width,
                                          size.height, most_sizes));
  }
  sizes_.push_back({size, {}});
  return &sizes_.back();
}

const BoardViews::OneSize& BoardViews::of_most() const {
  static const OneSize none;
  const auto most = std::ranges::max_element(sizes_, {}, [](const OneSize& one) { return one.views.size(); });
  return most == sizes_.end() ? none : *most;
}

std::vector<const BoardViews::OneSize*> BoardViews::others() const {
  std::vector<const OneSize*> out;
  for (const OneSize& one : sizes_) {
    if (&one != &of_most()) out.push_back(&one);
  }
  return out;
}

}  // namespace pizarra::programs
