#pragma once

// One end of a serial line by these rules: it hands messages over and takes them in, each once.
//
//   sender    ENQ        block        EOT
//   receiver       ACK0         ACK1          // ACK0 and ACK1 in turn, so that a lost answer is told from a lost block
//
// Lifecycle: open(); send() and receive(), one at a time. A cancelled one leaves a link half way; the next begins
// afresh. Where an answer is lost the sender asks for it again (ENQ), a block whose sum is wrong comes again (NAK), and
// a block that comes twice is one. A receiver that has heard all of a text and waits for EOT in vain takes the text for
// complete.
//
// Where both begin at once the one that insists goes first: the controller. Its text then was for a client that is
// gone, and is dropped. So nobody takes the answer to another's question.
//
// How many times and how long it waits is its own choice, as those of a controller are its parameters.

#include "blackboard/time/executor.hpp"
#include "drivers/arm/motoman/bsc_block.hpp"

namespace pizarra::arm {

class BscStation {
 public:
  enum class Manners : std::uint8_t { yields, insists };
  static constexpr Duration answer_time = 150ms;
  static constexpr Duration text_time = 600ms;  // a block of 256 characters takes 300 ms at 9600 baud
  static constexpr int tries = 8;

  // The wire outlives it.
  BscStation(Executor& executor, line::ByteWire& wire, Manners manners)
      : executor_(executor), wire_(wire), signs_(wire, frame_of_bsc), manners_(manners) {}
  Task<Result<void>> open(Time deadline);
  // Failures: disconnected, where the other end has nothing of it; no-answer, where it may have it.
  Task<Result<void>> send(BscMessage message);
  // Failures: timeout, where nobody begins; bad-reply, where it ends half way; disconnected.
  Task<Result<BscMessage>> receive(Time deadline);

 private:
  // The next sign. Failures: timeout, disconnected.
  Task<Result<BscSign>> next(Time deadline);
  Task<Result<BscSign>> next_within(Duration patience);
  Task<void> drop_what_came();
  // The link is made: the other end waits for blocks.
  Task<Result<void>> bid();
  Task<Result<void>> hand_over(std::string block, BscSign::Kind expected);
  // After the other end's ENQ.
  Task<Result<BscMessage>> take_in();
  void say(std::string_view what) { static_cast<void>(wire_.write(what)); }

  Executor& executor_;
  line::ByteWire& wire_;
  line::Frames signs_;
  Manners manners_;
};

}  // namespace pizarra::arm
