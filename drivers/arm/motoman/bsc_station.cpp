#include "drivers/arm/motoman/bsc_station.hpp"

namespace pizarra::arm {

using SignKind = BscSign::Kind;

Task<Result<void>> BscStation::open(Time deadline) {
  signs_.clear();
  Result<void> open = co_await wire_.open(deadline);
  co_return open;
}

Task<Result<BscSign>> BscStation::next(Time deadline) {
  while (true) {
    const Result<std::string> frame = co_await signs_.next(deadline);
    // A block that never ends is noise.
    if (!frame) signs_.clear();
    if (!frame) co_return fail(frame);
    if (!frame->empty()) co_return read_bsc(*frame);
  }
}

Task<Result<BscSign>> BscStation::next_within(Duration patience) {
  const Time deadline = executor_.now() + patience;
  Result<BscSign> sign = co_await next(deadline);
  co_return sign;
}

Task<void> BscStation::drop_what_came() {
  Result<std::string> bytes;
  while (bytes) {
    const Time now = executor_.now();
    bytes = co_await wire_.read(now);
  }
  signs_.clear();
}

Task<Result<void>> BscStation::bid() {
  for (int i = 0; i < tries; ++i) {
    const Result<void> asked = wire_.write(bsc::enquiry);
    if (!asked) co_return fail("disconnected", asked.error().sentence);
    const Time deadline = executor_.now() + answer_time;
    bool waiting = true;
    while (waiting) {
      const Result<BscSign> sign = co_await next(deadline);
      if (!sign && sign.error().symbol == "disconnected") co_return fail(sign);
      waiting = sign.has_value();
      if (!waiting) continue;
      if (sign->kind == SignKind::ack0) co_return Result<void>();
      // It has a text of ours that it waits to be told the end of.
      if (sign->kind == SignKind::ack1) say(bsc::end);
      if (sign->kind == SignKind::enquiry && manners_ == Manners::yields) {
        [[maybe_unused]] const Result<BscMessage> for_nobody = co_await take_in();
        waiting = false;
      }
    }
  }
  co_return fail("disconnected", "no answer comes from the other end of the line");
}

Task<Result<void>> BscStation::hand_over(std::string block, SignKind expected) {
  say(block);
  for (int i = 0; i < tries; ++i) {
    const Result<BscSign> answer = co_await next_within(answer_time);
    if (!answer && answer.error().symbol == "disconnected") co_return fail("no-answer", answer.error().sentence);
    if (!answer) {
      say(bsc::enquiry);
      continue;
    }
    if (answer->kind == expected) co_return Result<void>();
    if (answer->kind == SignKind::end) co_return fail("no-answer", "the other end broke the text off");
    // The answer to the block before: this one was not heard.
    const bool unheard =
        answer->kind == SignKind::nak || answer->kind == SignKind::ack0 || answer->kind == SignKind::ack1;
    say(unheard ? std::string_view(block) : bsc::enquiry);
  }
  co_return fail("no-answer", "the other end does not confirm what it was sent");
}

Task<Result<void>> BscStation::send(BscMessage message) {
  if (manners_ == Manners::yields) co_await drop_what_came();
  const Result<void> begun = co_await bid();
  if (!begun) co_return begun;
  SignKind expected = SignKind::ack1;
  for (std::string& block : write_bsc(message)) {
    const Result<void> handed = co_await hand_over(std::move(block), expected);
    if (!handed) co_return handed;
    expected = expected == SignKind::ack1 ? SignKind::ack0 : SignKind::ack1;
  }
  say(bsc::end);
  co_return Result<void>();
}

Task<Result<BscMessage>> BscStation::take_in() {
  constexpr std::size_t longest_message = 64 << 10;
  constexpr int most_signs = 1000;
  BscMessage message;
  std::optional<BscMessage> last;
  bool complete = false;
  std::string_view answer = bsc::ack0;
  say(answer);
  for (int i = 0; i < most_signs && message.text.size() <= longest_message; ++i) {
    const Result<BscSign> sign = co_await next_within(text_time);
    const bool over = sign ? sign->kind == SignKind::end : sign.error().symbol == "timeout";
    if (over && complete) co_return message;
    if (over) break;
    if (!sign) co_return fail(sign);
    if (sign->kind == SignKind::enquiry) say(answer);
    if (sign->kind == SignKind::damaged) say(bsc::nak);
    if (sign->kind != SignKind::block) continue;
    const BscMessage& part = sign->part;
    if (!last || *last != part) {
      if (!part.header.empty()) message = {part.header, ""};
      message.text += part.text;
      complete = sign->last && !message.header.empty();
      last = part;
      answer = answer == bsc::ack0 ? bsc::ack1 : bsc::ack0;
    }
    say(answer);
  }
  co_return fail("bad-reply", "the text that came over the line was broken off");
}

Task<Result<BscMessage>> BscStation::receive(Time deadline) {
  while (true) {
    const Result<BscSign> sign = co_await next(deadline);
    if (!sign) co_return fail(sign);
    if (sign->kind != SignKind::enquiry) continue;
    Result<BscMessage> message = co_await take_in();
    co_return message;
  }
}

}  // namespace pizarra::arm
