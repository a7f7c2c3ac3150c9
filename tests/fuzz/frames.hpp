#pragma once

// The frames of a fuzzed conversation: the lines of a text, in which a word stands for what the other side has to say
// rightly to be heard at all.
//
//   frames_of("(ping SESSION)\n(bye SESSION)", "SESSION", "4711")     // "(ping 4711)", "(bye 4711)"

#include <string>
#include <string_view>
#include <vector>

namespace pizarra {

inline std::vector<std::string> frames_of(std::string_view text, std::string_view word, const std::string& meaning) {
  constexpr std::size_t most_frames = 64;  // fewer than a socket holds
  std::vector<std::string> frames;
  while (!text.empty() && frames.size() < most_frames) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string frame(text.substr(0, end));
    for (std::size_t at = frame.find(word); at != std::string::npos; at = frame.find(word, at + meaning.size())) {
      frame.replace(at, word.size(), meaning);
    }
    frames.push_back(std::move(frame));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return frames;
}

}  // namespace pizarra
