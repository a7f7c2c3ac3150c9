#include "blackboard/journal/remembered_replies.hpp"

#include "blackboard/limits.hpp"
#include "blackboard/wire/wire.hpp"
#include "lisp/writer.hpp"

namespace pizarra::journal {

namespace {

// A line takes one more reply as long as it has no more.
constexpr std::size_t bytes_of_a_line = 64 << 10;
constexpr ReadLimits line_limits = {
    .bytes = 2 * limits::frame_bytes, .depth = limits::frame_depth, .elements = 2 * limits::frame_elements};
constexpr std::string_view line_ends = ")\n";

bool is_of_a_former_file(const Datum& line) { return line.size() >= 4 && line.size() <= 5 && !line[2].is_string(); }

bool add_reply(std::vector<RememberedReply>& replies, RememberedReply reply, const Datum& request,
               const Datum& result) {
  const std::optional<std::uint64_t> number = wire::count_from(request);
  if (!number) return false;
  reply.request = *number;
  reply.result = result;
  replies.push_back(std::move(reply));
  return true;
}

// Whether the line is sound.
bool add_replies(std::vector<RememberedReply>& replies, const Datum& line) {
  const std::optional<std::uint64_t> session = wire::count_at(line, 0);
  if (!session || line.size() < 4 || !line[1].is_string()) return false;
  RememberedReply of_session{.session = *session, .teller = std::string(line[1].text()), .request = 0, .result = {}};
  if (is_of_a_former_file(line)) {
    if (line.size() == 5) of_session.key = line[4].text();
    return add_reply(replies, of_session, line[2], line[3]);
  }
  of_session.key = line[2].text();
  bool sound = line.size() % 2 == 1;
  for (std::size_t i = 3; sound && i < line.size(); i += 2) {
    sound = add_reply(replies, of_session, line[i], line[i + 1]);
  }
  return sound;
}

}  // namespace

void ReplyLines::add(std::string& text, const RememberedReply& reply) {
  if (session_ == reply.session && text.size() - line_begins_ <= bytes_of_a_line) {
    text.resize(text.size() - line_ends.size());
  } else {
    session_ = reply.session;
    line_begins_ = text.size();
    write_number_to(text += '(', reply.session);
    write_string_to(text += ' ', reply.teller);
    write_string_to(text += ' ', reply.key);
  }
  write_number_to(text += ' ', reply.request);
  write_to(text += ' ', reply.result);
  text += line_ends;
}

std::optional<std::vector<RememberedReply>> replies_from(std::string_view text) {
  std::vector<RememberedReply> replies;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const Result<Datum> line = read_one(text.substr(0, end), line_limits, "journal");
    if (!line || !add_replies(replies, *line)) return std::nullopt;
    text.remove_prefix(end + 1);
  }
  return replies;
}

}  // namespace pizarra::journal
