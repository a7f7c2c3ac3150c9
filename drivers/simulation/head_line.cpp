#include "drivers/simulation/head_line.hpp"

#include "drivers/simulation/hand_request.hpp"

namespace pizarra::simulation {

HeadLine::HeadLine(Executor& executor, const PtuModel& model)
    : executor_(executor), unit_(executor, model), said_(executor) {
  unit_.on_say([this](std::string_view bytes) {
    // What nobody hears is lost.
    unheard_.append(bytes.substr(0, most_unheard - unheard_.size()));
    said_.wake_all();
  });
}

Task<Result<Message>> HeadLine::handle(Datum request) {
  const std::string_view what = word(request, 1);
  if (what == "hear" && request.size() == 2) {
    co_return co_await hear();
  }
  if (what == "send" && request.size() == 3 && request[2].is_string()) {
    unit_.receive(request[2].text());
    co_return Message();
  }
  const std::string_view power = word(request, 2);
  if (what != "power" || (power != "on" && power != "off")) co_return bad_request(request);
  unit_.power(power == "on");
  co_return Message();
}

Task<Result<Message>> HeadLine::hear() {
  const Time deadline = executor_.now() + hearing_time;
  while (unheard_.empty()) {
    const bool said = co_await said_.wait(deadline);
    if (!said) break;
  }
  const std::string heard = std::exchange(unheard_, {});
  Message message;
  message.head = list(heard);
  co_return message;
}

}  // namespace pizarra::simulation
