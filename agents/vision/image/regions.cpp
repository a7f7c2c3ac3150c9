#include "agents/vision/image/regions.hpp"

#include <algorithm>

namespace pizarra::vision {
namespace {

struct Run {
  int first;
  int end;
  int region;
};

// A region while it grows. One that met an older one points to that.
struct Growing {
  int parent;
  int area_px;
  int left, top, right, bottom;  // right and bottom exclusive
  int start_x;
};

class Growth {
 public:
  // A run of row y that touches none above.
  int begin(int first, int end, int y) {
    const int number = static_cast<int>(regions_.size());
    regions_.push_back({number, end - first, first, y, end, y + 1, first});
    return number;
  }
  void extend(int region, int first, int end, int y) {
    Growing& grown = regions_[static_cast<std::size_t>(region)];
    grown.area_px += end - first;
    grown.left = std::min(grown.left, first);
    grown.right = std::max(grown.right, end);
    grown.bottom = y + 1;
  }
  int root(int region) {
    while (at(region).parent != region) {
      at(region).parent = at(at(region).parent).parent;
      region = at(region).parent;
    }
    return region;
  }
  // The older takes up the younger, whose start is never before its own.
  int join(int a, int b) {
    if (a == b) return a;
    Growing& older = at(std::min(a, b));
    Growing& younger = at(std::max(a, b));
    younger.parent = std::min(a, b);
    older.area_px += younger.area_px;
    older.left = std::min(older.left, younger.left);
    older.right = std::max(older.right, younger.right);
    older.bottom = std::max(older.bottom, younger.bottom);
    return std::min(a, b);
  }
  std::vector<Region> result() const {
    std::vector<Region> out;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      const Growing& r = regions_[i];
      if (r.parent != static_cast<int>(i)) continue;
      out.push_back({r.area_px, {r.left, r.top, r.right - r.left, r.bottom - r.top}, {r.start_x, r.top}});
    }
    return out;
  }

 private:
  Growing& at(int region) { return regions_[static_cast<std::size_t>(region)]; }
  std::vector<Growing> regions_;
};

}  // namespace

std::vector<Region> regions_of(const BitImage& bits) {
  Growth growth;
  std::vector<Run> above;
  std::vector<Run> here;
  for (int y = 0; y < bits.rows(); ++y) {
    here.clear();
    std::size_t first_above = 0;
    for_each_run_of_bits(bits.row(y), bits.words_a_row(), [&](int first, int end) {
      while (first_above < above.size() && above[first_above].end < first) ++first_above;
      int region = -1;
      for (std::size_t i = first_above; i < above.size() && above[i].first <= end; ++i) {
        const int met = growth.root(above[i].region);
        region = region < 0 ? met : growth.join(region, met);
      }
      if (region < 0) {
        region = growth.begin(first, end, y);
      } else {
        growth.extend(region, first, end, y);
      }
      here.push_back({first, end, region});
    });
    std::swap(above, here);
  }
  return growth.result();
}

}  // namespace pizarra::vision
