#pragma once

// The controller of a Motoman arm as its host control has it: commands in text, answered with data or a code of four
// digits, whichever line carries them.
//
//   HostControl control(cabinet);
//   const HostAnswer answer = co_await control.carry_out("SVON", "1");
//   const Job serving = executor.spawn(serve_ethernet_server(executor, control, *tcp_port));
//   const Job serving = executor.spawn(serve_bsc(executor, control, *pty));
//
// It knows RSTATS, RALARM, RPOSJ, RPOSC, SVON, HOLD, RESET, CANCEL, PMOVJ, MOVL, and SAVEV and LOADV of D variables. It
// refuses an unknown command with 1010, a wrong number of operands with 1011 and an impossible value with 1012. A
// refusal of the cabinet has its own code.
//
// How far it is proven: with the driver of drivers/arm/motoman/ alone.

#include "drivers/line/byte_wire.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

struct HostAnswer {
  std::uint16_t refusal = 0;
  std::string data = {};  // of a question
};

class HostControl {
 public:
  // The cabinet outlives it.
  explicit HostControl(ArmCabinet& cabinet) : controller_(cabinet) {}
  bool powered() { return controller_.cabinet().powered(); }
  Task<HostAnswer> carry_out(std::string name, std::string operands);

 private:
  using Numbers = std::vector<double>;
  Task<HostAnswer> status(Numbers);
  Task<HostAnswer> alarms(Numbers);
  Task<HostAnswer> pulses(Numbers);
  Task<HostAnswer> pose(Numbers operands);
  Task<HostAnswer> servo(Numbers operands);
  Task<HostAnswer> hold(Numbers operands);
  Task<HostAnswer> reset(Numbers);
  Task<HostAnswer> cancel(Numbers);
  Task<HostAnswer> move_pulses(Numbers operands);
  Task<HostAnswer> move_line(Numbers operands);
  Task<HostAnswer> save_variable(Numbers operands);
  Task<HostAnswer> load_variable(Numbers operands);
  struct Command {
    std::string_view name;
    std::size_t operands;
    Task<HostAnswer> (HostControl::*carry_out)(Numbers);
  };
  static const Command commands[];

  MotomanController controller_;
};

// "0000" or the refusal's four digits.
std::string host_code(std::uint16_t refusal);

// A session a client, one after another; one without Keep-Alive ends with its first command. Half a minute of silence
// ends any, as does what is no request. Each until destroyed. All outlive them.
Task<void> serve_ethernet_server(Executor& executor, HostControl& control, line::ByteWire& port);
Task<void> serve_bsc(Executor& executor, HostControl& control, line::ByteWire& line);

}  // namespace pizarra::simulation
