// A board that cannot confirm that it leads: another one may by now. It changes nothing and answers no question.
// A client that asks for it learns how things stood, and when that was last certain.

#include "blackboard/server/board_server.hpp"
#include "blackboard/server/reply_text.hpp"
#include "lisp/writer.hpp"

namespace pizarra::server {

namespace {

bool wants_to_know(const Datum& message) {
  return message.is_form("hello") && message.size() > 4 && message[4].is_symbol("doubts");
}

bool recalls(const Datum& message) {
  return message.is_form("request") && message.size() > 3 && message[3].is_form("recall") && wire::count_at(message, 2);
}

}  // namespace

std::string BoardServer::answer_in_doubt(const std::string& sender_key, std::string_view frame, Duration age) {
  const Result<std::vector<Datum>> messages = wire::read_messages(frame);
  if (!messages || leaving_) return "";
  bool spoken_to = false;
  std::string replies;
  for (const Datum& message : *messages) {
    spoken_to = spoken_to || wants_to_know(message) || recalls(message);
    // What has no room is asked for again.
    const bool answers = recalls(message) && replies.size() < wire::bytes_together;
    if (answers) replies += recall_in_doubt(sender_key, message, age);
  }
  return spoken_to ? write(list("unavailable"_sym, age.count())) + replies : "";
}

std::string BoardServer::recall_in_doubt(const std::string& sender_key, const Datum& request, Duration age) {
  const wire::PublicKey* const key = keys_ && !sender_key.empty() ? keys_->find(sender_key) : nullptr;
  if (keys_ && !sender_key.empty() && key == nullptr) return "";
  const std::string nobody;
  std::size_t examined = 0;
  const Result<Datum> value = permitted_.recall({nobody, nobody, key}, request[3], age, examined);
  return reply_text(*wire::count_at(request, 2), result_to_datum(value));
}

}  // namespace pizarra::server
