#include "agents/vision/marks/edge_chains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "agents/vision/image/contour.hpp"

namespace pizarra::vision {
namespace {

constexpr double smoothing_px = 1;
// By how much grey levels change over a pixel along an edge: everywhere, and somewhere in its neighbourhood; and of the
// noise that is left.
constexpr double least_slope = 2.5;
constexpr double least_slope_somewhere = 6;
constexpr double least_of_noise = 2;
constexpr double by_sobel = 8;
// Chains that are shorter say nothing.
constexpr std::size_t shortest_px = 12;
constexpr int reach_px = 2;

struct Slopes {
  cv::Mat1s along, down;

  cv::Vec2f light(cv::Point p) const {
    const cv::Vec2f slope(along(p), down(p));
    const auto length = static_cast<float>(cv::norm(slope));
    return length > 0 ? slope / length : cv::Vec2f(1, 0);
  }
};

class ChainFollower {
 public:
  ChainFollower(cv::Mat1b edges, const Slopes& slopes) : left_(std::move(edges)), slopes_(slopes) {}

  bool is_left(cv::Point p) const { return left_(p) != 0; }
  // Takes its pixels away.
  EdgeChain chain_through(cv::Point start) {
    std::vector<cv::Point> there = walk_from(start);
    const std::vector<cv::Point> back = walk_from(start);
    std::ranges::reverse(there);
    there.push_back(start);
    there.insert(there.end(), back.begin(), back.end());
    EdgeChain out;
    for (const cv::Point& p : there) out.push_back({p, slopes_.light(p)});
    return out;
  }

 private:
  // The neighbours whose edge turns least, on and on.
  std::vector<cv::Point> walk_from(cv::Point at) {
    std::vector<cv::Point> out;
    left_(at) = 0;
    while (true) {
      const cv::Vec2f light = slopes_.light(at);
      cv::Point best = at;
      float likest = -2;
      for (const auto& [dx, dy] : neighbours) {
        const cv::Point next = at + cv::Point(dx, dy);
        if (!cv::Rect({}, left_.size()).contains(next) || left_(next) == 0) continue;
        const float like = slopes_.light(next).dot(light);
        if (like > likest) {
          likest = like;
          best = next;
        }
      }
      if (best == at) return out;
      left_(best) = 0;
      out.push_back(best);
      at = best;
    }
  }

  cv::Mat1b left_;
  const Slopes& slopes_;
};

int direction_at(double turn) {
  return (cvFloor(turn * EdgeChains::directions / (2 * std::numbers::pi)) + EdgeChains::directions) %
         EdgeChains::directions;
}

// The bits of a direction and of the one that it is nearer to.
std::uint16_t bits_of(const cv::Vec2f& light) {
  constexpr double half = std::numbers::pi / EdgeChains::directions;
  const double turn = std::atan2(light[1], light[0]);
  return static_cast<std::uint16_t>((1U << direction_at(turn - half)) | (1U << direction_at(turn + half)));
}

}  // namespace

int EdgeChains::direction_of(const cv::Vec2d& light) { return direction_at(std::atan2(light[1], light[0])); }

bool EdgeChains::is_edge(const cv::Point2d& at, const cv::Vec2d& light) const {
  const int x = cvRound(at.x);
  const int y = cvRound(at.y);
  if (x < 0 || y < 0 || x >= near.cols || y >= near.rows) return false;
  return ((near(y, x) >> direction_of(light)) & 1) != 0;
}

EdgeChains EdgeChains::within(const cv::Rect& area) const {
  EdgeChains out;
  out.near = near;
  for (const EdgeChain& chain : chains) {
    EdgeChain part;
    for (const EdgePlace& place : chain) {
      if (area.contains(place.at)) part.push_back(place);
    }
    if (part.size() >= shortest_px) out.chains.push_back(std::move(part));
  }
  return out;
}

EdgeChains edge_chains(const ImageCut& cut) {
  cv::Mat1b smooth;
  cv::GaussianBlur(cut.pixels, smooth, {}, smoothing_px);
  Slopes slopes;
  cv::Sobel(smooth, slopes.along, CV_16S, 1, 0);
  cv::Sobel(smooth, slopes.down, CV_16S, 0, 1);
  cv::Mat1b edges;
  const double noise = least_of_noise * cut.noise;
  cv::Canny(slopes.along, slopes.down, edges, by_sobel * std::max(least_slope, noise / 2),
            by_sobel * std::max(least_slope_somewhere, noise), true);
  EdgeChains out;
  out.near = cv::Mat_<std::uint16_t>::zeros(edges.size());
  ChainFollower follower(edges.clone(), slopes);
  for (int y = reach_px; y < edges.rows - reach_px; ++y) {
    for (int x = reach_px; x < edges.cols - reach_px; ++x) {
      if (edges(y, x) == 0) continue;
      const std::uint16_t bits = bits_of(slopes.light({x, y}));
      for (int dy = -reach_px; dy <= reach_px; ++dy) {
        for (int dx = -reach_px; dx <= reach_px; ++dx) out.near(y + dy, x + dx) |= bits;
      }
    }
  }
  for (int y = 0; y < edges.rows; ++y) {
    for (int x = 0; x < edges.cols; ++x) {
      if (!follower.is_left({x, y})) continue;
      EdgeChain chain = follower.chain_through({x, y});
      if (chain.size() >= shortest_px) out.chains.push_back(std::move(chain));
    }
  }
  return out;
}

}  // namespace pizarra::vision
