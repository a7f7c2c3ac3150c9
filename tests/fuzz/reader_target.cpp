// A datum that was read is written so that it is read again as the same; a text with places finds them.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

using namespace pizarra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  ReadLimits with_commas;
  with_commas.commas = true;
  [[maybe_unused]] const Result<Datum> thesis = read_one(text, with_commas);
  if (const Result<Datum> datum = read_one(text)) {
    const Result<Datum> again = read_one(write(*datum));
    if (!again || *again != *datum) std::abort();
  }
  if (const Result<Source> source = read_source(std::string(text), "input")) {
    [[maybe_unused]] const Failure failure = source->failure_at({0, 1, 0}, "symbol", "sentence", {"context"});
  }
  return 0;
}
