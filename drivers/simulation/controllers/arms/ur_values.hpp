#pragma once

// What programs and clients of the data exchange write: registers and inputs, by their names there, and the digital
// outputs.
//
//   values.set("output_int_register_24", 7);
//   values.set_output(3, true);
//   values.numbers(), values.outputs();

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace pizarra::simulation {

class UrValues {
 public:
  void set(const std::string& name, double value) { numbers_[name] = value; }
  void set_output(int number, bool on);
  // The digital outputs of a bank, those of them that the mask means.
  void set_outputs(std::string_view bank);
  const std::map<std::string, double, std::less<>>& numbers() const { return numbers_; }
  std::uint32_t outputs() const { return outputs_; }  // a bit each

 private:
  std::map<std::string, double, std::less<>> numbers_;
  std::uint32_t outputs_ = 0;
};

}  // namespace pizarra::simulation
