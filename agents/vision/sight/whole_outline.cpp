#include "agents/vision/sight/whole_outline.hpp"

namespace pizarra::vision {
namespace {

// The pose may be another form, or no plane, with this probability at most.
constexpr double most_odds = 1e-3;
// At least this share of the outer border must be registered.
constexpr double least_registered = 0.95;
// Edges that are off together may put the centre off by this much at most, as a part of what may be told surely.
constexpr double most_bent = 0.5;

double registered_share(const PlaneOutline& outline, const PlaneFit& fit) {
  int all = 0;
  int registered = 0;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.counts || edge.point >= outline.outermost || outline.points[edge.point].is_rounded()) continue;
    ++all;
    registered += edge.is_border ? 1 : 0;
  }
  return all == 0 ? 0 : static_cast<double>(registered) / all;
}

}  // namespace

bool is_registered(const PlaneOutline& outline, const PlaneFit& fit, double most_off_px) {
  return registered_share(outline, fit) >= least_registered && off_if_bent_px(outline, fit) < most_bent * most_off_px;
}

std::optional<double> off_by_outline_px(const RegisteredOutline& seen, double most_off_px) {
  const PlaneOutline& outline = seen.sample.plane;
  if (seen.pose.is_contradicted() || seen.pose.odds_of_no_plane() > most_odds) return std::nullopt;
  if (!is_registered(outline, seen.left, most_off_px)) return std::nullopt;
  if (seen.right_shows_mark && (seen.right == nullptr || !is_registered(outline, *seen.right, most_off_px))) {
    return std::nullopt;
  }
  return seen.pose.most_off_if_hidden_px();
}

}  // namespace pizarra::vision
