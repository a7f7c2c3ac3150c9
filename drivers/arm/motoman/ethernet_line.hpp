#pragma once

// Host control over Yaskawa's Ethernet Server: TCP port 80 of controllers from the NX100 on. A session is opened for
// any number of commands; the controller closes it after half a minute of silence and after what it does not
// understand, and it is then opened anew.
//
//   CONNECT Robot_access Keep-Alive:-1<CR><LF>      OK: NX Information Server(Ver) Keep-Alive:-1.<CR><LF>
//   HOSTCTRL_REQUEST SVON 2<CR><LF>                 OK: SVON<CR><LF>
//   1<CR>                                           0000<CR>
//
// A command begins only with its operands: one that fails before they are sent may be tried again, also a motion. A
// motion whose answer does not come after them fails with `no-answer`. Questions and other orders are then asked again
// for a second.
//
// How far it is proven: docs/write-a-driver.md.

#include "blackboard/time/turns.hpp"
#include "drivers/arm/motoman/host_command.hpp"
#include "drivers/line/device_at.hpp"
#include "drivers/line/frames.hpp"

namespace pizarra::arm {

inline constexpr std::uint16_t ethernet_server_port = 80;

class EthernetLine : public HostLine {
 public:
  // The wire outlives it.
  EthernetLine(Executor& executor, line::ByteWire& wire)
      : executor_(executor),
        wire_(wire),
        device_(line::device_at("the controller", wire.place())),
        lines_(wire, line::frame_of_line),
        turns_(executor) {}
  Task<Result<void>> open(Time deadline) override;
  Task<Result<std::string>> command(HostCommand command) override;

 private:
  static constexpr Duration answer_time = 400ms;
  static constexpr Duration patience = 1s;
  static constexpr Duration pause = 100ms;
  Task<Result<void>> begin_session(Time deadline);
  Task<Result<std::string>> take_turn(const HostCommand& command);
  // Disconnected, where it was not begun; no-answer and bad-reply where it may have been.
  Task<Result<std::string>> exchange(const HostCommand& command);
  Task<Result<std::string>> said(const HostCommand& command);
  std::unexpected<Failure> unreached(const char* symbol, const Failure& why) const;
  std::unexpected<Failure> unanswered(const char* symbol, const Failure& why) const;
  std::unexpected<Failure> strange(const HostCommand& command, std::string_view answer) const;

  Executor& executor_;
  line::ByteWire& wire_;
  const std::string device_;
  line::Frames lines_;
  Turns turns_;
  // Nothing is under way over it. The answer to an exchange that was cut off in the middle would go to the next one.
  bool session_ = false;
};

}  // namespace pizarra::arm
