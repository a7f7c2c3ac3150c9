#include "drivers/camera/film_source.hpp"

#include <fmt/format.h>

#include "drivers/camera/image_faults.hpp"

namespace pizarra::camera {

Result<void> FilmSource::open() {
  Result<std::unique_ptr<FilmReader>> film = new_film_reader();
  if (!film) return fail(film);
  film_ = std::move(*film);
  taken_any_ = false;
  if (!film_->open(path_)) return fail("disconnected", fmt::format("{} cannot be opened", path_));
  recorded_hz_ = rate_hz_ > 0 ? rate_hz_ : film_->pictures_per_second();
  return {};
}

Result<std::optional<double>> FilmSource::grab() {
  const std::optional<double> moment_ms = film_->grab();
  if (moment_ms) {
    taken_any_ = true;
    return moment_ms;
  }
  if (taken_any_) return fail("ended", fmt::format("{} is over", path_));
  return fail("disconnected", fmt::format("{} gives no images", path_));
}

Result<cv::Mat> FilmSource::retrieve(bool grey) {
  cv::Mat picture = film_->picture(grey);
  if (picture.empty()) return image_fault(fmt::format("what {} gives {}", path_, no_image));
  return picture;
}

}  // namespace pizarra::camera
