// `measure`: what can be measured in an image file, whether learned or not.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/segmentation.hpp"
#include "agents/vision/marks/tag_text.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "lisp/json.hpp"
#include "lisp/numbers.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/board_session.hpp"
#include "programs/commands/commands.hpp"
#include "programs/commands/pose_words.hpp"
#include "programs/commands/still_camera.hpp"

namespace pizarra::programs {
namespace {

struct MeasureChoices {
  std::vector<std::string> families;  // none: all
  StillChoices stills;
};

// The smallest rectangle around a mark's pixels.
struct MarkFrame {
  double length_px;
  double width_px;
  double turn_deg;  // of its longer side from the image's rows, clockwise, above -90 to 90
};

MarkFrame frame_of(const vision::SeenMark& mark) {
  // From the middles of the outermost pixels to their edges.
  constexpr double to_edges_px = 1;
  const cv::RotatedRect box = cv::minAreaRect(mark.contour);
  const bool lies = box.size.width >= box.size.height;
  double turn = lies ? box.angle : box.angle + 90;
  while (turn > 90) turn -= 180;
  while (turn <= -90) turn += 180;
  return {std::max(box.size.width, box.size.height) + to_edges_px,
          std::min(box.size.width, box.size.height) + to_edges_px, rounded(turn, 10)};
}

struct Measured {
  std::vector<vision::SeenMark> marks;  // that are no tags
  std::size_t left_out;                 // smaller ones
  std::vector<vision::FoundMark> tags;
};

Measured measure(const StillImage& image, const vision::TagsInView& families) {
  vision::StereoSight sight = sight_of(image);
  Measured out{sight.left_segmentation().marks(), sight.left_segmentation().left_out(), families.at(sight)};
  std::erase_if(out.marks, [&](const vision::SeenMark& mark) {
    return std::ranges::any_of(out.tags, [&](const vision::FoundMark& tag) {
      const std::vector<cv::Point2f> corners(tag.pair.left.corners.begin(), tag.pair.left.corners.end());
      return cv::pointPolygonTest(corners, cv::Point2f(mark.centre), false) >= 0;
    });
  });
  return out;
}

double side_px_of(const vision::SeenMark& tag) {
  const std::vector<cv::Point2f> corners(tag.corners.begin(), tag.corners.end());
  return cv::arcLength(corners, true) / 4;
}

std::string_view tone_word(const vision::SeenMark& mark) {
  return mark.tone == vision::MarkTone::dark ? "dark" : "light";
}

class Measuring {
 public:
  Measuring(const Stills& stills, const vision::TagsInView& families) : stills_(stills), families_(families) {}

  int run(bool json) const {
    return stills_.each([this, json](const StillImage& image) {
      const Measured measured = measure(image, families_);
      json ? tell_json(image, measured) : tell(image, measured);
      return exit_reached;
    });
  }

 private:
  void tell(const StillImage& image, const Measured& measured) const {
    const std::string left_out =
        measured.left_out == 0 ? "" : fmt::format(" ({} smaller regions were not looked at)", measured.left_out);
    fmt::print("{}: {} x {} px, {}{}, {}\n", image.name, image.grey.cols, image.grey.rows,
               counted(measured.marks.size(), "mark"), left_out, counted(measured.tags.size(), "tag"));
    for (const vision::SeenMark& mark : measured.marks) {
      const MarkFrame frame = frame_of(mark);
      const cv::Point2d at = image.in_file(mark.centre);
      fmt::print(
          "  {} mark at {:.2f} {:.2f} px, size {:.1f} x {:.1f} px, turned {:.1f} degrees, area {:.0f} px, "
          "perimeter {} px\n",
          tone_word(mark), at.x, at.y, frame.length_px, frame.width_px, frame.turn_deg, mark.area_px,
          mark.perimeter_px);
    }
    for (const vision::FoundMark& tag : measured.tags) {
      const vision::SeenMark& seen = tag.pair.left;
      const cv::Point2d at = image.in_file(seen.centre);
      const vision::MarkPose* pose = stills_.pose_of(tag);
      fmt::print("  tag {} at {:.2f} {:.2f} px, side {:.1f} px, area {:.0f} px, confidence {:.3f}{}\n", tag.name, at.x,
                 at.y, side_px_of(seen), seen.area_px, tag.confidence, pose != nullptr ? ", " + pose_words(*pose) : "");
    }
  }

  void tell_json(const StillImage& image, const Measured& measured) const {
    std::vector<std::string> marks;
    for (const vision::SeenMark& mark : measured.marks) {
      const MarkFrame frame = frame_of(mark);
      const cv::Point2d at = image.in_file(mark.centre);
      marks.push_back(
          fmt::format("{{\"tone\":\"{}\",\"at\":[{:.2f},{:.2f}],\"size\":[{:.1f},{:.1f}],\"turn\":{:.1f},"
                      "\"area\":{:.0f},\"perimeter\":{}}}",
                      tone_word(mark), at.x, at.y, frame.length_px, frame.width_px, frame.turn_deg, mark.area_px,
                      mark.perimeter_px));
    }
    std::vector<std::string> tags;
    for (const vision::FoundMark& tag : measured.tags) {
      const vision::SeenMark& seen = tag.pair.left;
      const cv::Point2d at = image.in_file(seen.centre);
      const vision::MarkPose* pose = stills_.pose_of(tag);
      tags.push_back(
          fmt::format("{{\"tag\":{},\"at\":[{:.2f},{:.2f}],\"side\":{:.1f},\"area\":{:.0f},"
                      "\"confidence\":{:.3f}{}}}",
                      json_string(tag.name), at.x, at.y, side_px_of(seen), seen.area_px, tag.confidence,
                      pose != nullptr ? "," + pose_json(*pose) : ""));
    }
    fmt::print("{{\"image\":{},\"width\":{},\"height\":{},\"marks\":[{}],\"left_out\":{},\"tags\":[{}]}}\n",
               json_string(image.name), image.grey.cols, image.grey.rows, fmt::join(marks, ","), measured.left_out,
               fmt::join(tags, ","));
  }

  const Stills& stills_;
  const vision::TagsInView& families_;
};

Result<std::vector<vision::SizedFamily>> families_of(const MeasureChoices& choices) {
  std::vector<vision::SizedFamily> out;
  for (const std::string& name : choices.families) {
    const Result<const vision::TagFamily*> family = vision::family_from_text(name);
    if (!family) return fail(family);
    out.push_back({std::string((*family)->name), choices.stills.side_mm});
  }
  if (!out.empty()) return out;
  for (const vision::TagFamily& family : vision::tag_families()) {
    out.push_back({std::string(family.name), choices.stills.side_mm});
  }
  return out;
}

int run_measure(const MeasureChoices& choices) {
  const repl::Style style = choices.stills.style();
  const Result<std::vector<vision::SizedFamily>> families = families_of(choices);
  if (!families) return complain_as(style, families.error(), exit_usage);
  const Result<Stills> stills = Stills::open(choices.stills);
  if (!stills) return complain_as(style, stills.error(), exit_usage);
  return Measuring(*stills, vision::TagsInView(*families)).run(choices.stills.json);
}

}  // namespace

void add_measure_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<MeasureChoices>();
  CLI::App* word = app.add_subcommand(
      "measure",
      "Measure what image files show, without a cell and without anything learned: the marks, closed regions that are\n"
      "darker or lighter than all around them, and the tags.");
  add_image_option(*word, choices->stills);
  word->add_option("--tags", choices->families, "The families of tags to look for, such as 36h11,4x4-50; else all")
      ->delimiter(',')
      ->type_name("FAMILY,...");
  add_still_options(*word, choices->stills);
  word->add_flag("--json", choices->stills.json, "One JSON object an image");
  word->footer(help_footer("measure shots/1.jpg --tags 36h11 --focal 560 --side 40",
                           "Exit status: 0 measured, whatever is to be seen; 2 a wrong word or option;\n"
                           "4 an image cannot be read (the others are looked at all the same)."));
  word->callback([choices, &status] { status = run_measure(*choices); });
}

}  // namespace pizarra::programs
