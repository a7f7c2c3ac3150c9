#include "drivers/simulation/link_wire.hpp"

#include <algorithm>
#include <cstring>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"

namespace pizarra::simulation::link_wire {

namespace {

constexpr std::size_t most_parts = 8;
constexpr std::int64_t widest_image = 1 << 14;

std::unexpected<Failure> nonsense(const Datum& datum) {
  return fail("bad-message", "this is no message of the device link", datum);
}

Result<Datum> read_text(std::string_view text) {
  ReadLimits limits;
  limits.bytes = longest_text;
  return read_one(text, limits);
}

bool whole(const Datum& datum, std::int64_t low, std::int64_t high) {
  return datum.is_integer() && datum.integer() >= low && datum.integer() <= high;
}

Result<std::shared_ptr<const Image>> read_image(const Datum& shape, const zmq::message_t& part) {
  const bool sound = shape.size() == 3 && whole(shape[0], 1, widest_image) && whole(shape[1], 1, widest_image) &&
                     whole(shape[2], 1, 4);
  if (!sound) return nonsense(shape);
  auto image = std::make_shared<Image>();
  image->width = static_cast<int>(shape[0].integer());
  image->height = static_cast<int>(shape[1].integer());
  image->channels = static_cast<int>(shape[2].integer());
  const auto* bytes = part.data<std::uint8_t>();
  image->pixels.assign(bytes, bytes + part.size());
  return image;
}

}  // namespace

std::string call_text(const Call& call) { return write(list("call"_sym, call.id, call.request)); }

Result<Call> read_call(std::string_view text) {
  const Result<Datum> datum = read_text(text);
  if (!datum) return fail(datum);
  const bool sound = datum->is_form("call") && datum->size() == 3 && (*datum)[1].is_integer();
  if (!sound) return nonsense(*datum);
  return Call{static_cast<std::uint64_t>((*datum)[1].integer()), (*datum)[2]};
}

Parts answer_parts(const WireAnswer& answer) {
  Parts parts(1);
  if (!answer.message) {
    const Datum failed = list("answer"_sym, answer.id, failure_to_datum(answer.message.error()), Datum());
    parts[0] = zmq::message_t(write(failed));
    return parts;
  }
  std::vector<Datum> shapes;
  for (const auto& image : answer.message->images) {
    shapes.push_back(list(image->width, image->height, image->channels));
    parts.emplace_back(image->pixels.data(), image->pixels.size());
  }
  const Datum head = list("answer"_sym, answer.id, answer.message->head, Datum::list(std::move(shapes)));
  parts[0] = zmq::message_t(write(head));
  return parts;
}

Result<WireAnswer> read_answer(const Parts& parts) {
  if (parts.empty()) return nonsense({});
  const Result<Datum> datum = read_text(parts[0].to_string_view());
  if (!datum) return fail(datum);
  const bool sound = datum->is_form("answer") && datum->size() == 4 && (*datum)[1].is_integer() &&
                     (*datum)[3].size() + 1 == parts.size() && (*datum)[3].size() <= most_images;
  if (!sound) return nonsense(*datum);
  WireAnswer answer{static_cast<std::uint64_t>((*datum)[1].integer()), {}};
  if ((*datum)[2].is_form("fail")) {
    answer.message = fail(failure_from_datum((*datum)[2]));
    return answer;
  }
  answer.message->head = (*datum)[2];
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    Result<std::shared_ptr<const Image>> image = read_image((*datum)[3][i], parts[i + 1]);
    if (!image) return fail(image);
    answer.message->images.push_back(std::move(*image));
  }
  return answer;
}

std::optional<Parts> receive_parts(zmq::socket_t& socket) {
  Parts parts;
  bool more = true;
  while (more) {
    zmq::message_t part;
    // Parts of one message arrive together, so only the first can be missing.
    if (!socket.recv(part, zmq::recv_flags::dontwait)) return std::nullopt;
    more = part.more();
    if (parts.size() < most_parts) parts.push_back(std::move(part));
  }
  return parts;
}

void limit(zmq::socket_t& socket) {
  socket.set(zmq::sockopt::linger, 0);
  socket.set(zmq::sockopt::sndhwm, most_queued);
  socket.set(zmq::sockopt::rcvhwm, most_queued);
  socket.set(zmq::sockopt::maxmsgsize, longest_message);
}

}  // namespace pizarra::simulation::link_wire
