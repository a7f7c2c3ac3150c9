#pragma once

// The file control of Yaskawa's High Speed Ethernet Server, at a UDP port of its own: files sent there, fetched, listed
// and deleted, in blocks that are each acknowledged. Job files (*.JBI) are the controller's jobs.
//
//   HsesFiles files;
//   const std::string reply = files.answer(datagram);       // empty: it says nothing
//   files.find("PICK.JBI")                                  // its text, or nullptr
//
// One transfer at a time; the next ends the one before. How far it is proven: with what fs100 and moto-hses send; the
// refusals' codes but that of a file that is not there are taken from the robot control.

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/line/octets.hpp"

namespace pizarra::simulation {

class HsesFiles {
 public:
  static constexpr std::uint16_t port = 10041;

  std::string answer(std::string_view datagram);
  const std::string* find(std::string_view name) const;

 private:
  static constexpr std::size_t most_files = 1000;
  static constexpr std::size_t longest_file = 1 << 20;
  struct Message {
    std::uint8_t kind = 0;  // a request, or a block or its acknowledgement
    std::uint8_t id = 0;
    std::uint32_t block = 0;
    std::uint8_t service = 0;
    std::string_view data;
  };
  std::string carry_out(const Message& message);
  std::string next_block(const Message& message);
  std::string take_block(const Message& message);
  std::string send(const Message& message, const std::string& text);
  std::string list(std::string_view pattern) const;

  std::map<std::string, std::string, std::less<>> files_;
  std::deque<std::string> leaving_;  // blocks that are still to go
  std::uint32_t left_ = 0;           // how many went
  std::string last_said_;            // the block before that
  std::string coming_name_;          // empty: none comes
  std::string coming_;
  std::optional<std::uint32_t> taken_;  // the block that came last
};

}  // namespace pizarra::simulation
