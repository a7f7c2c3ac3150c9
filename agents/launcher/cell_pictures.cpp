#include "agents/launcher/cell_pictures.hpp"

#include <opencv2/imgproc.hpp>

#include "drivers/camera/image_file.hpp"

namespace pizarra::launcher {

namespace {

constexpr int most_px = 2048;  // no camera of a simulated cell shows more of it

using Photograph = std::shared_ptr<const simulation::Photograph>;

Result<Photograph> photograph_of(const std::optional<forms::CellPicture>& picture) {
  if (!picture) return Photograph();
  const Result<cv::Mat> read = camera::read_image_file(picture->file, false);
  if (!read) {
    Failure failure = read.error();
    failure.place = picture->named_at;
    return fail(std::move(failure));
  }
  cv::Mat bgr = *read;
  const double larger = static_cast<double>(std::max(bgr.cols, bgr.rows)) / most_px;
  if (larger > 1) cv::resize(*read, bgr, {}, 1 / larger, 1 / larger, cv::INTER_AREA);
  Image image{bgr.cols, bgr.rows, bgr.channels(), {}};
  for (int y = 0; y < bgr.rows; ++y) {
    image.pixels.insert(image.pixels.end(), bgr.ptr(y), bgr.ptr(y) + bgr.cols * bgr.channels());
  }
  return std::make_shared<const simulation::Photograph>(std::move(image));
}

}  // namespace

Result<void> put_pictures(simulation::WorldConfig& config, const forms::CellDescription& description) {
  const Result<Photograph> background = photograph_of(description.background);
  if (!background) return fail(background);
  const Result<Photograph> table = photograph_of(description.table_picture);
  if (!table) return fail(table);
  config.background = *background;
  config.table_picture = *table;
  return {};
}

}  // namespace pizarra::launcher
