#include "tests/bench/vision/photographs.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

#include "agents/vision/sight/mark_learner.hpp"
#include "tests/bench/child.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {
namespace {

constexpr const char* part_made = ".part";  // behind the folder's name, while it is not complete
constexpr std::array shapes = {"circle", "square", "cross", "triangle"};

cv::Mat1b grey_image(const std::string& path) {
  cv::Mat1b out = cv::imread(path, cv::IMREAD_GRAYSCALE);
  if (out.empty()) throw std::runtime_error(path + " cannot be read");
  return out;
}

// A line of truth.txt.
void read_line(const std::string& line, const std::string& folder, PhotographSet& out) {
  std::istringstream words(line);
  std::string condition, file, kind;
  PhotographedMark mark;
  words >> condition >> file >> kind >> mark.name >> mark.centre.x >> mark.centre.y >> mark.hidden;
  for (int i = 0; i < 3; ++i) words >> mark.place_mm[i];
  for (double& number : mark.turn.val) words >> number;
  if (!words) throw std::runtime_error("truth.txt has a line that is none: " + line);
  const std::string path = folder + "/" + file;
  if (condition == "learning") {
    out.learning.path = path;
    out.learning.marks.push_back(mark);
    return;
  }
  if (out.photographs.empty() || out.photographs.back().path != path) {
    out.photographs.push_back({condition, path, kind});
  }
  if (mark.name != "-") out.photographs.back().marks.push_back(mark);
}

// `script`: with its options.
void run_script(const std::string& folder, const std::string& script) {
  const std::string begun = folder + part_made;
  std::filesystem::remove_all(begun);
  const std::string command =
      fmt::format("/usr/bin/python3 -B '{}/tests/bench/vision/photographs/'{} '{}'", source_dir(), script, begun);
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("the photographs cannot be made; ./pizarra bench --install-peers installs what they need");
  }
  std::filesystem::rename(begun, folder);
}

PhotographSet made_by(const std::string& script, const std::string& folder) {
  if (!std::filesystem::exists(folder + "/truth.txt")) run_script(folder, script);
  std::ifstream truth(folder + "/truth.txt");
  if (!truth) throw std::runtime_error(folder + " has no truth.txt");
  PhotographSet out;
  for (std::string line; std::getline(truth, line);) read_line(line, folder, out);
  return out;
}

std::string right_of(const std::string& path) { return path.substr(0, path.rfind('.')) + "-right.jpg"; }

}  // namespace

cv::Mat1b Photograph::left() const { return grey_image(path); }

cv::Mat1b Photograph::right() const { return grey_image(right_of(path)); }

bool Photograph::has_right() const { return std::filesystem::exists(right_of(path)); }

PhotographFolder::PhotographFolder(const std::string& named, const std::string& what)
    : path_(named), goes_(named.empty()) {
  if (goes_) path_ = fmt::format("{}/pizarra-{}-{}", std::filesystem::temp_directory_path().string(), what, getpid());
}

PhotographFolder::~PhotographFolder() {
  std::error_code ignored;
  if (!goes_) return;
  std::filesystem::remove_all(path_, ignored);
  std::filesystem::remove_all(path_ + part_made, ignored);
}

camera::StereoModel photographs_camera() {
  return {.width = 640,
          .height = 480,
          .focal_px = 600,
          .centre_x_px = 319.5,
          .centre_y_px = 239.5,
          .base_line_mm = 0,
          .learned_at_mm = 500};
}

camera::StereoModel photographs_pair() {
  camera::StereoModel out = photographs_camera();
  out.base_line_mm = 80;
  return out;
}

PhotographSet make_photographs(const std::string& folder, std::uint64_t seed, int scenes) {
  return made_by(fmt::format("make_photographs.py --seed {} --scenes {}", seed, scenes), folder);
}

PhotographSet make_films(const std::string& folder, std::uint64_t seed, int films) {
  return made_by(fmt::format("make_films.py --seed {} --films {}", seed, films), folder);
}

vision::LearnedObjects learn_from(const Photograph& photo, const camera::StereoModel& model) {
  vision::LearnedObjects out;
  const cv::Mat1b image = photo.left();
  const cv::Mat1b beside = model.is_single() ? cv::Mat1b::zeros(image.size()) : photo.right();
  for (const PhotographedMark& mark : photo.marks) {
    vision::MarkLearner learner(mark.name, mark.centre, out);
    while (!learner.done()) {
      vision::StereoSight sight(image, beside, model);
      const Result<void> fed = learner.feed(sight);
      if (!fed) throw std::runtime_error(mark.name + " cannot be learned: " + describe(fed.error()));
    }
    vision::LearnedSample sample = learner.sample();
    sample.number = 1;
    out.add(mark.name, std::move(sample));
  }
  return out;
}

int tag_in_place_of(const std::string& shape) {
  return static_cast<int>(std::ranges::find(shapes, shape) - shapes.begin());
}

}  // namespace pizarra::bench
