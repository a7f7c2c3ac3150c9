#include "tests/bench/vision/tag_detectors.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <memory>
#include <opencv2/aruco.hpp>

namespace pizarra::bench {
namespace {

// Tags of 4 x 4 cells within a border: the largest cells, hence the easiest, at a given size.
TagDetector aruco() {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  TagDetector out{.name = "ArUco", .tags = {}, .detect = {}};
  for (int i = 0; i < tags_of_a_scene; ++i) {
    cv::Mat drawn;
    dictionary->drawMarker(i, 6, drawn);
    out.tags.emplace_back(drawn == 0);
  }
  out.detect = [dictionary](const cv::Mat& grey) {
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> numbers;
    cv::aruco::detectMarkers(grey, dictionary, corners, numbers);
    std::vector<SeenTag> seen;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::vector<cv::Point2f>& c = corners[i];
      seen.push_back({numbers[i], cv::Point2d((c[0] + c[1] + c[2] + c[3]) * 0.25F), c});
    }
    return seen;
  };
  return out;
}

TagDetector apriltag() {
  const std::shared_ptr<apriltag_family_t> family(tag36h11_create(), tag36h11_destroy);
  // It goes before its family does.
  const std::shared_ptr<apriltag_detector_t> detector(
      apriltag_detector_create(), [family](apriltag_detector_t* d) { apriltag_detector_destroy(d); });
  apriltag_detector_add_family(detector.get(), family.get());
  TagDetector out{.name = "AprilTag", .tags = {}, .detect = {}};
  for (int i = 0; i < tags_of_a_scene; ++i) {
    image_u8_t* drawn = apriltag_to_image(family.get(), static_cast<std::uint32_t>(i));
    const cv::Mat cells(drawn->height, drawn->width, CV_8UC1, drawn->buf, static_cast<std::size_t>(drawn->stride));
    // Its picture has a white frame of one cell.
    out.tags.emplace_back(cells(cv::Rect(1, 1, cells.cols - 2, cells.rows - 2)) == 0);
    image_u8_destroy(drawn);
  }
  out.detect = [detector](const cv::Mat& grey) {
    image_u8_t image{grey.cols, grey.rows, static_cast<std::int32_t>(grey.step), grey.data};
    const std::unique_ptr<zarray_t, void (*)(zarray_t*)> found(apriltag_detector_detect(detector.get(), &image),
                                                               apriltag_detections_destroy);
    std::vector<SeenTag> seen;
    for (int i = 0; i < zarray_size(found.get()); ++i) {
      apriltag_detection_t* tag = nullptr;
      zarray_get(found.get(), i, &tag);
      SeenTag one{tag->id, {tag->c[0] - 0.5, tag->c[1] - 0.5}, {}};
      // They go counterclockwise, and half a pixel is the middle of the first one.
      for (const int k : {3, 2, 1, 0}) {
        one.corners.emplace_back(static_cast<float>(tag->p[k][0] - 0.5), static_cast<float>(tag->p[k][1] - 0.5));
      }
      seen.push_back(std::move(one));
    }
    return seen;
  };
  return out;
}

}  // namespace

std::vector<TagDetector> tag_detectors() { return {aruco(), apriltag()}; }

}  // namespace pizarra::bench
