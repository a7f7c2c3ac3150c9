#include "agents/vision/sight/hand_held_marks.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <opencv2/imgproc.hpp>

#include "agents/vision/objects/mark_choice.hpp"

namespace pizarra::vision {
namespace {

// Of the image's width: farther no mark moves from one image to the next.
constexpr double reach_share = 0.25;
// What may change meanwhile, as ratios: a mark's height and area, and how far marks are apart.
constexpr double most_height_ratio = 1.25;
constexpr double most_area_ratio = 1.6;
constexpr double most_scale_ratio = 1.2;
constexpr double most_turn = 15 * CV_PI / 180;
// How far a mark is from where the others say, in an image 320 px wide and as a share of its distance from the one that
// is counted from: perspective.
constexpr double slack_px = 3;
constexpr double slack_share = 0.08;
// Those whose places are compared, the nearest; and of these the nearest, by pairs of which a motion is known.
constexpr std::size_t most_known = 12;
constexpr std::size_t most_anchors = 5;
// Of the likeliest motions so many are tried on the images, and of each that puts the mark at one place.
constexpr std::size_t most_tried = 32;
constexpr int most_tried_a_place = 3;
// How well images must fit, as a correlation, and how much worse they do where another of its like is taken for it.
constexpr double least_fit = 0.3;
constexpr double rival_share = 0.85;

constexpr int relief_width = 160;

using Complex = std::complex<double>;

Complex place_of(const SeenMark& mark) { return {mark.centre.x, mark.centre.y}; }

bool within_ratio(double a, double b, double most) { return a <= most * b && b <= most * a; }

// From one image to the next, turned by less than the step between two samples of a signature and a half.
bool are_alike(const SeenMark& a, const SeenMark& b) {
  if (a.tone != b.tone || a.tag != b.tag) return false;
  if (!within_ratio(a.height_px, b.height_px, most_height_ratio)) return false;
  if (!within_ratio(a.area_px, b.area_px, most_area_ratio)) return false;
  return a.tag || signature_error(a.signature, b.signature) < recognition_threshold;
}

// A mark of the image before, and those of this one that are like it.
struct Known {
  const SeenMark* mark;
  std::vector<const SeenMark*> alike = {};
  Complex place() const { return place_of(*mark); }
};

// From one image to the next; and how many of the known marks are where it would have brought them.
struct Motion {
  Complex from;
  Complex to;
  Complex by = 1;
  int seen = 0;
  double fit = 0;
  Complex operator()(Complex place) const { return to + by * (place - from); }
};

// How well the image before, moved, fits the one now.
double fit_of(const Motion& motion, const MarkedImage& before, const MarkedImage& now) {
  const double scale = static_cast<double>(now.relief.cols) / now.size.width;
  const Complex shift = scale * motion(0);
  const cv::Matx23d matrix(motion.by.real(), -motion.by.imag(), shift.real(), motion.by.imag(), motion.by.real(),
                           shift.imag());
  cv::Mat1f moved;
  cv::Mat1b within;
  cv::warpAffine(before.relief, moved, matrix, now.relief.size());
  cv::warpAffine(cv::Mat1b(before.relief.size(), 255), within, matrix, now.relief.size(), cv::INTER_NEAREST);
  cv::Mat1f seen = cv::Mat1f::zeros(now.relief.size());
  cv::Mat1f expected = cv::Mat1f::zeros(now.relief.size());
  now.relief.copyTo(seen, within);
  moved.copyTo(expected, within);
  const double both = std::sqrt(seen.dot(seen) * expected.dot(expected));
  return both > 0 ? seen.dot(expected) / both : 0;
}

class Refinding {
 public:
  Refinding(const SeenMark& mark, const MarkedImage& before, const MarkedImage& now) : before_(before), now_(now) {
    for (const SeenMark& each : before.marks) known_.push_back({&each});
    std::ranges::stable_sort(known_, {}, [&](const Known& each) { return std::abs(each.place() - place_of(mark)); });
    const bool first_is_it =
        !known_.empty() && known_.front().mark->box.contains(mark.centre) && are_alike(mark, *known_.front().mark);
    if (first_is_it) {
      known_.front().mark = &mark;
    } else {
      known_.insert(known_.begin(), {&mark});
    }
    if (known_.size() > most_known) known_.erase(known_.begin() + most_known, known_.end());
    for (Known& each : known_) {
      for (const SeenMark& seen : now.marks) {
        if (are_alike(*each.mark, seen)) each.alike.push_back(&seen);
      }
    }
  }

  Refound find() const {
    std::vector<Motion> motions = likeliest_motions();
    for (Motion& motion : motions) motion.fit = fit_of(motion, before_, now_);
    const Motion& best = *std::ranges::max_element(motions, {}, &Motion::fit);
    if (best.fit < least_fit) return {};
    const bool ambiguous = std::ranges::any_of(
        motions, [&](const Motion& other) { return other.fit > rival_share * best.fit && !puts_alike(other, best); });
    if (ambiguous) return {nullptr, true};
    return {seen_at(best, clicked()), false};
  }

 private:
  const Known& clicked() const { return known_.front(); }

  bool puts_alike(const Motion& a, const Motion& b) const {
    const cv::Rect& box = clicked().mark->box;
    return std::abs(a(clicked().place()) - b(clicked().place())) < std::min(box.width, box.height) / 2.0;
  }

  // The one where the motion would have brought it; null: none.
  const SeenMark* seen_at(const Motion& motion, const Known& known) const {
    const double unit = std::max(1.0, now_.size.width / 320.0);
    const double slack = unit * slack_px + slack_share * std::abs(known.place() - motion.from);
    const Complex place = motion(known.place());
    const auto off = [&](const SeenMark* seen) { return std::abs(place_of(*seen) - place); };
    const auto nearest = std::ranges::min_element(known.alike, {}, off);
    return nearest != known.alike.end() && off(*nearest) <= slack ? *nearest : nullptr;
  }

  // Those that bring most of the marks to where their like is; and rest, always.
  std::vector<Motion> likeliest_motions() const {
    const Complex place = clicked().place();
    std::vector<Motion> all{{place, place}};
    const std::size_t anchors = std::min(known_.size(), most_anchors);
    for (std::size_t i = 0; i < anchors; ++i) {
      for (std::size_t j = i + 1; j < anchors; ++j) add_motions_of(known_[i], known_[j], all);
      for (const SeenMark* to : known_[i].alike) {
        if (is_in_reach(known_[i], *to)) all.push_back({known_[i].place(), place_of(*to)});
      }
    }
    for (Motion& motion : all) {
      motion.seen = static_cast<int>(
          std::ranges::count_if(known_, [&](const Known& each) { return seen_at(motion, each) != nullptr; }));
    }
    std::stable_sort(all.begin() + 1, all.end(), [](const Motion& a, const Motion& b) { return a.seen > b.seen; });
    std::vector<Motion> out;
    for (const Motion& motion : all) {
      const auto alike = std::ranges::count_if(out, [&](const Motion& other) { return puts_alike(motion, other); });
      if (alike < most_tried_a_place && out.size() < most_tried) out.push_back(motion);
    }
    return out;
  }

  bool is_in_reach(const Known& from, const SeenMark& to) const {
    return std::abs(place_of(to) - from.place()) <= reach_share * now_.size.width;
  }

  // That bring both to where their like is.
  void add_motions_of(const Known& a, const Known& b, std::vector<Motion>& out) const {
    const Complex apart = b.place() - a.place();
    // Marks within one another say nothing of how the image turned.
    if (std::abs(apart) < std::max(a.mark->box.height, b.mark->box.height)) return;
    for (const SeenMark* to : a.alike) {
      if (!is_in_reach(a, *to)) continue;
      for (const SeenMark* other : b.alike) {
        const Complex by = (place_of(*other) - place_of(*to)) / apart;
        const bool possible = within_ratio(std::abs(by), 1, most_scale_ratio) && std::abs(std::arg(by)) < most_turn;
        if (possible) out.push_back({a.place(), place_of(*to), by});
      }
    }
  }

  const MarkedImage& before_;
  const MarkedImage& now_;
  std::vector<Known> known_;  // the clicked one first, then by their distance from it
};

}  // namespace

MarkedImage marked_image(const cv::Mat& grey, std::vector<SeenMark> marks) {
  const double scale = static_cast<double>(relief_width) / grey.cols;
  cv::Mat small;
  cv::resize(grey, small, {relief_width, std::max(1, cvRound(scale * grey.rows))}, 0, 0, cv::INTER_AREA);
  small.convertTo(small, CV_32F);
  cv::Mat1f fine;
  cv::Mat1f coarse;
  cv::GaussianBlur(small, fine, {}, 1.5);
  cv::GaussianBlur(small, coarse, {}, 10);
  return {grey.size(), std::move(marks), fine - coarse};
}

Refound refind(const SeenMark& mark, const MarkedImage& before, const MarkedImage& now) {
  return Refinding(mark, before, now).find();
}

}  // namespace pizarra::vision
