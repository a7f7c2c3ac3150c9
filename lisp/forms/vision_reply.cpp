#include "lisp/forms/vision_reply.hpp"

#include "lisp/guile/scheme.hpp"

namespace pizarra::forms {

Result<Source> read_vision_reply(std::string_view text) {
  const ReadLimits limits{.bytes = 1 << 16, .depth = 3, .elements = 10'000, .commas = true};
  return read_source(text, "vision", limits);
}

Result<Datum> interpret_vision_reply(std::string_view text) {
  const Result<Source> source = read_vision_reply(text);
  if (!source) return fail(source);
  return guile::interpret(*source, "vision-replies");
}

}  // namespace pizarra::forms
