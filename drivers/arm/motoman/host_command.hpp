#pragma once

// Commands of Yaskawa's host control, in text: a name and operands, answered with data or a code of four digits. The
// Ethernet Server (TCP) and the serial lines of older controllers carry the same.
//
//   HostCommand{"PMOVJ", "50,0,1000,0,0,0,0,0,0,0,0,0,0,0", HostCommand::Kind::motion}
//   numbers_in("-12,1000, 0.5\r")            // -12, 1000, 0.5

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::arm {

struct HostCommand {
  enum class Kind : std::uint8_t {
    question,  // answered with data; may be asked again
    order,     // answered with 0000; may be given again
    motion,    // as an order, but never given twice by whoever carries it
    stop,      // an order that waits for no answer but that which is on its way
  };
  std::string name;
  std::string operands = {};
  Kind kind = Kind::question;
};

// Numbers between commas, blanks and line ends around them. None where one is no finite number, or there are over 64.
std::optional<std::vector<double>> numbers_in(std::string_view text);

// Carries commands to a controller, one after another.
class HostLine {
 public:
  virtual ~HostLine() = default;
  virtual Task<Result<void>> open(Time deadline) = 0;
  // The data of a question. Failures: refused, whose subject is the code, its digits taken as hexadecimal;
  // disconnected, where nothing was carried out; no-answer and bad-reply, where nobody knows.
  virtual Task<Result<std::string>> command(HostCommand command) = 0;
  // ArmDriver's.
  virtual Duration longest_silence() const { return 150ms; }
};

// The failure of a refusal with this code.
std::unexpected<Failure> refused_command(const std::string& name, std::string_view code);
// Whether the text is a code of four digits; "0000" says that all is well.
bool is_host_code(std::string_view text);

}  // namespace pizarra::arm
