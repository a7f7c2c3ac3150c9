#include "blackboard/server/in_doubt.hpp"

#include "blackboard/server/replies.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

namespace {

bool wants_to_know(const Datum& message) {
  return message.is_form("hello") && message.size() > 4 && message[4].is_symbol("doubts");
}

bool recalls(const Datum& message) {
  return message.is_form("request") && message.size() > 3 && message[3].is_form("recall") && wire::count_at(message, 2);
}

std::string recall(PermittedBoard& board, const wire::PublicKey* key, const Datum& request, Duration age) {
  const std::string nobody;
  std::size_t examined = 0;
  const Result<Datum> value = board.recall({nobody, nobody, key}, request[3], age, examined);
  return reply_text(*wire::count_at(request, 2), result_to_datum(value));
}

}  // namespace

std::string answer_in_doubt(PermittedBoard& board, const KeyFolder* keys, const std::string& sender_key,
                            std::string_view frame, Duration age) {
  const Result<std::vector<Datum>> messages = wire::read_messages(frame);
  if (!messages) return "";
  const bool with_key = keys != nullptr && !sender_key.empty();
  const wire::PublicKey* const key = with_key ? keys->find(sender_key) : nullptr;
  const bool is_stranger = with_key && key == nullptr;
  bool spoken_to = false;
  std::string replies;
  for (const Datum& message : *messages) {
    spoken_to = spoken_to || wants_to_know(message) || recalls(message);
    // What has no room is asked for again.
    const bool answers = recalls(message) && !is_stranger && replies.size() < wire::bytes_together;
    if (answers) replies += recall(board, key, message, age);
  }
  return spoken_to ? write(list("unavailable"_sym, age.count())) + replies : "";
}

}  // namespace pizarra::server
