#include "drivers/line/dialogue.hpp"

namespace pizarra::line {

Task<Result<void>> Dialogue::open(Time deadline) {
  Result<void> open = co_await wire_.open(deadline);
  frames_.clear();
  co_return open;
}

Task<Result<std::string>> Dialogue::ask(std::string question, Fits fits) {
  const Turns::Turn turn = co_await turns_.take();
  const Result<void> sent = say(question);
  if (!sent) co_return fail("disconnected", sent.error().sentence);
  co_return co_await answer(std::move(fits));
}

Task<Result<std::string>> Dialogue::ask_at_once(std::string question, Fits fits) {
  const Result<void> sent = say(question);
  if (!sent) co_return fail("disconnected", sent.error().sentence);
  const Turns::Turn turn = co_await turns_.take();
  co_return co_await answer(std::move(fits));
}

Task<Result<std::string>> Dialogue::answer(Fits fits) {
  const Time deadline = executor_.now() + answer_time;
  while (true) {
    Result<std::string> answer = co_await next(deadline);
    if (!answer) co_return fail("disconnected", device_ + " did not answer: " + answer.error().sentence);
    if (fits(*answer)) co_return answer;
  }
}

}  // namespace pizarra::line
