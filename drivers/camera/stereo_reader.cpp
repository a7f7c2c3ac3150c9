#include "drivers/camera/stereo_reader.hpp"

#include <cassert>
#include <cmath>
#include <fmt/format.h>

namespace pizarra::camera {
namespace {

constexpr double usual_live_hz = 30;
// Of the lagging camera, before the pair is given up.
constexpr int most_catching_up = 16;

}  // namespace

StereoReader::StereoReader(const forms::CameraSetup& setup, Sources sources, std::function<Time()> now)
    : setup_(setup), sources_(std::move(sources)), now_(std::move(now)), moments_ms_(sources_.size()) {
  assert(!sources_.empty());
}

std::string StereoReader::camera(std::size_t source) const {
  if (sources_.size() == 1) return "the camera";
  return source == 0 ? "the left camera" : "the right camera";
}

Failure StereoReader::named(std::size_t source, const Failure& failure) const {
  return {failure.symbol, fmt::format("{}: {}", camera(source), failure.sentence), failure.subject, failure.place};
}

Result<void> StereoReader::open() {
  taken_any_ = false;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Result<void> opened = sources_[i]->open();
    if (!opened) return fail(named(i, opened.error()));
  }
  for (const auto& source : sources_) skewed_ += source->left_out();
  return {};
}

void StereoReader::close() {
  for (const auto& source : sources_) source->close();
}

Result<double> StereoReader::grab_one(std::size_t source) {
  const Result<std::optional<double>> moment = sources_[source]->grab();
  if (!moment) return fail(named(source, moment.error()));
  const double arrived_ms = static_cast<double>(now_().time_since_epoch().count()) / 1000;
  return moment->value_or(arrived_ms);
}

Result<void> StereoReader::grab_all() {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Result<double> moment = grab_one(i);
    if (!moment) return fail(moment);
    moments_ms_[i] = *moment;
  }
  return sources_.size() == 2 ? fit_moments() : Result<void>();
}

Result<void> StereoReader::fit_moments() {
  const double rate_hz = setup_.rate_hz > 0 ? setup_.rate_hz : recorded_hz() > 0 ? recorded_hz() : usual_live_hz;
  const double most_ms = setup_.skew_ms > 0 ? setup_.skew_ms : 500 / rate_hz;
  for (int i = 0; i < most_catching_up; ++i) {
    const double skew_ms = moments_ms_[0] - moments_ms_[1];
    if (std::abs(skew_ms) <= most_ms) return {};
    ++skewed_;
    const std::size_t older = skew_ms < 0 ? 0 : 1;
    const Result<double> moment = grab_one(older);
    if (!moment) return fail(moment);
    moments_ms_[older] = *moment;
  }
  return fail("corrupt-frame", fmt::format("the two cameras' images are {:.0f} ms apart, more than {:.0f}",
                                           std::abs(moments_ms_[0] - moments_ms_[1]), most_ms));
}

Result<void> StereoReader::grab() {
  Result<void> grabbed = grab_all();
  if (!grabbed && grabbed.error().symbol == "ended" && !once_) {
    if (!taken_any_) return fail("disconnected", grabbed.error().sentence);
    const Result<void> begun = open();
    if (!begun) return begun;
    grabbed = grab_all();
  }
  if (!grabbed) return grabbed;
  taken_any_ = true;
  captured_ = now_();
  return {};
}

Result<StereoImages> StereoReader::retrieve(bool grey) {
  StereoImages out;
  out.captured = captured_;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    Result<cv::Mat> image = sources_[i]->retrieve(grey);
    if (!image) return fail(named(i, image.error()));
    (i == 0 ? out.left : out.right) = std::move(*image);
  }
  if (setup_.arrangement == forms::CameraSetup::Arrangement::side_by_side) {
    const int half = out.left.cols / 2;
    out.right = out.left.colRange(half, 2 * half);
    out.left = out.left.colRange(0, half);
  }
  const Result<void> fits = check_size(out);
  if (!fits) return fail(fits);
  return out;
}

Result<void> StereoReader::check_size(const StereoImages& images) const {
  const cv::Size size = images.left.size();
  if (size.empty()) return fail("corrupt-frame", "the camera's images are too narrow to hold two side by side");
  if (!images.right.empty() && images.right.size() != size) {
    return fail("corrupt-frame", fmt::format("the left camera's image is {}x{}, the right one's {}x{}", size.width,
                                             size.height, images.right.cols, images.right.rows));
  }
  if (setup_.width > 0 && size != cv::Size(setup_.width, setup_.height)) {
    return fail("corrupt-frame", fmt::format("the camera's image is {}x{}, and {}x{} was asked for", size.width,
                                             size.height, setup_.width, setup_.height));
  }
  return {};
}

}  // namespace pizarra::camera
