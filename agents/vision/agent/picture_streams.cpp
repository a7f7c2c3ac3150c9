#include "agents/vision/agent/picture_streams.hpp"

#include <fmt/format.h>

#include "agents/vision/agent/grey_pair.hpp"

namespace pizarra::vision {
namespace {

constexpr std::string_view stream_kinds[] = {"left", "right", "grey", "colour", "annotated"};

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
  return streams_ != nullptr && (watched("colour") || watched("annotated")) && showing_.done();
}

void PictureStreams::begin_showing(const camera::StereoFrame& frame, Annotation annotation) {
  showing_ = context_.executor.spawn(show(frame, std::move(annotation)));
}

// The eyes' own images are always grey, so that nothing they tell depends on who watches: the same frame, or the next
// where the camera has moved on, is asked for once more in colour. While they learn or track, the picture of it stays
// grey, as the thesis has it, and what they mark stands out.
Task<void> PictureStreams::show(camera::StereoFrame frame, Annotation annotation) {
  const Time before = frame.captured - Duration(1);
  const Result<camera::StereoFrame> coloured = co_await camera_.next(before, true);
  const bool usable = coloured && coloured->left != nullptr && coloured->left->width == frame.left->width &&
                      coloured->left->height == frame.left->height;
  const camera::StereoFrame& base = usable ? *coloured : frame;
  if (watched("colour")) streams_->publish(name_of("colour"), {base.number, base.captured, base.left});
  if (!watched("annotated")) co_return;
  const bool learning = !annotation.filled.empty() || !annotation.learned_contour.empty();
  const bool grey = learning || !annotation.sightings.empty();
  const Image& shown = grey ? *frame.left : *base.left;
  streams_->publish(name_of("annotated"), {frame.number, frame.captured, annotate(shown, annotation)});
}

}  // namespace pizarra::vision
