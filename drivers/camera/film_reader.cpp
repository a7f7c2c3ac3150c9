#include "drivers/camera/film_reader.hpp"

#include "drivers/camera/loaded_module.hpp"

namespace pizarra::camera {

Result<std::unique_ptr<FilmReader>> new_film_reader() {
  static const Result<const void*> loaded = symbol_in_module("pizarra-ffmpeg.so", "pizarra_new_film_reader");
  if (!loaded) return fail(loaded);
  const auto make = *static_cast<FilmReader* (*const*)()>(*loaded);
  return std::unique_ptr<FilmReader>(make());
}

}  // namespace pizarra::camera
