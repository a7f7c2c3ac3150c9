#include "drivers/line/told_state.hpp"

namespace pizarra::line {

void ToldState::forget() {
  listening_ = Job();
  told_at_.reset();
  why_unknown_ = line_.device() + " is not connected";
}

Task<Result<void>> ToldState::listen(Hear hear, Duration patience) {
  forget();
  why_unknown_ = silent();
  listening_ = line_.executor().spawn(go_on_listening(std::move(hear)));
  std::function<bool()> is_known = [this] { return known(); };
  const bool told = co_await until(std::move(is_known), patience);
  if (!told) co_return unknown();
  co_return Result<void>();
}

bool ToldState::known() const { return told_at_ && line_.executor().now() - *told_at_ <= fresh_; }

Task<void> ToldState::go_on_listening(Hear hear) {
  while (true) {
    const Time deadline = line_.executor().now() + look_again;
    const Result<std::string> message = co_await line_.next(deadline);
    if (!message && message.error().symbol == "timeout") continue;
    if (!message) {
      why_unknown_ = message.error().sentence;
      told_at_.reset();
      co_return;
    }
    const Result<bool> told = hear(*message);
    if (!told) why_unknown_ = told.error().sentence;
    if (!told || !*told) continue;
    told_at_ = line_.executor().now();
    why_unknown_ = silent();
    told_.wake_all();
  }
}

Task<bool> ToldState::until(std::function<bool()> what, Duration patience) {
  const Time deadline = line_.executor().now() + patience;
  while (!what()) {
    const bool woken = co_await told_.wait(deadline);
    if (!woken) co_return what();
  }
  co_return true;
}

}  // namespace pizarra::line
