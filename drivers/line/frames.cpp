#include "drivers/line/frames.hpp"

namespace pizarra::line {

Task<Result<std::string>> Frames::next(Time deadline) {
  while (true) {
    const Result<std::optional<Frame>> frame = reader_(unread_);
    if (!frame) co_return fail(frame);
    if (*frame) {
      std::string message((*frame)->message);
      unread_.erase(0, (*frame)->octets);
      co_return message;
    }
    if (unread_.size() > longest) co_return fail("bad-reply", "the device sends a message without an end");
    const Result<std::string> more = co_await wire_.read(deadline);
    if (!more) co_return fail(more);
    unread_ += *more;
  }
}

Result<std::optional<Frame>> frame_of_line(std::string_view octets) {
  const std::size_t begin = octets.find_first_not_of("\r\n");
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t end = octets.find_first_of("\r\n", begin);
  if (end == std::string_view::npos) return std::nullopt;
  return Frame{end + 1, octets.substr(begin, end - begin)};
}

}  // namespace pizarra::line
