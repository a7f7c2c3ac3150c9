#include "agents/vision/agent/picture_streams.hpp"

#include <fmt/format.h>

#include "agents/vision/sight/stereo_sight.hpp"

namespace pizarra::vision {
namespace {

constexpr std::string_view stream_kinds[] = {"left", "right", "grey", "colour", "annotated"};

std::shared_ptr<const Image> grey_image(const std::shared_ptr<const Image>& image) {
  if (image->channels == 1) return image;
  const cv::Mat grey = grey_of(*image);
  return std::make_shared<Image>(Image{image->width, image->height, 1, {grey.datastart, grey.dataend}});
}

}  // namespace

std::string PictureStreams::name_of(std::string_view kind) const { return fmt::format("{}-{}", context_.name, kind); }

std::vector<Datum> PictureStreams::facts() const {
  std::vector<Datum> out;
  if (streams_ == nullptr) return out;
  for (const std::string_view kind : stream_kinds) out.push_back(stream_fact(name_of(kind), kind, *streams_));
  return out;
}

bool PictureStreams::watched(std::string_view kind) const { return streams_->watched(name_of(kind)); }

void PictureStreams::publish(const camera::StereoFrame& frame) {
  if (streams_ == nullptr) return;
  const auto send = [&](std::string_view kind, std::shared_ptr<const Image> image) {
    streams_->publish(name_of(kind), {frame.number, frame.captured, std::move(image)});
  };
  if (watched("left")) send("left", frame.left);
  if (watched("right")) send("right", frame.right);
  if (watched("grey")) send("grey", grey_image(frame.left));
}

bool PictureStreams::person_watches() const {
  return streams_ != nullptr && (watched("colour") || watched("annotated"));
}

// While the eyes learn or track, the picture of it stays grey, as the thesis has it, and what they mark stands out. It
// is at hand at once.
void PictureStreams::show(const camera::StereoFrame& frame, const Annotation& annotation) {
  const bool learning = !annotation.filled.empty() || !annotation.learned_contour.empty();
  const bool grey = learning || !annotation.sightings.empty();
  if (grey && watched("annotated")) publish_annotated(frame, annotation);
  const bool in_colour = watched("colour") || !grey;
  if (in_colour && showing_.done()) showing_ = context_.executor.spawn(show_in_colour(frame, annotation, grey));
}

// The eyes' own images are always grey, so that nothing they tell depends on who watches: the same frame, or the next
// where the camera has moved on, is asked for once more in colour. What is shown is called by its own number.
Task<void> PictureStreams::show_in_colour(camera::StereoFrame frame, Annotation annotation, bool annotated) {
  const Time before = frame.captured - Duration(1);
  const Result<camera::StereoFrame> coloured = co_await camera_.next(before, true);
  const bool usable = coloured && coloured->left != nullptr && coloured->left->width == frame.left->width &&
                      coloured->left->height == frame.left->height;
  const camera::StereoFrame& shown = usable ? *coloured : frame;
  if (watched("colour")) streams_->publish(name_of("colour"), {shown.number, shown.captured, shown.left});
  if (!annotated && watched("annotated")) publish_annotated(shown, annotation);
}

void PictureStreams::publish_annotated(const camera::StereoFrame& shown, Annotation annotation) {
  annotation.status = fmt::format("frame {}   {}", shown.number, annotation.status);
  streams_->publish(name_of("annotated"), {shown.number, shown.captured, annotate(*shown.left, annotation)});
}

}  // namespace pizarra::vision
