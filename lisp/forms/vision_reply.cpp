#include "lisp/forms/vision_reply.hpp"

#include "lisp/guile/interpret.hpp"

namespace pizarra::forms {

Result<Datum> interpret_vision_reply(std::string_view text) {
  const ReadLimits limits{.bytes = 1 << 16, .depth = 3, .elements = 10'000, .commas = true};
  const Result<Source> source = read_source(text, "vision", limits);
  if (!source) return fail(source);
  return guile::interpret(*source, "vision-replies");
}

}  // namespace pizarra::forms
