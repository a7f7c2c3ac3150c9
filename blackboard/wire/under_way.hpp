#pragma once

// The bytes that ZeroMQ holds for each peer until the network takes them. Its own bound counts messages, whatever their
// size.
//
//   UnderWay under_way;
//   socket.send(under_way.message(peer, frame), ...);        // counted until it is gone, or was not sent at all
//   under_way.bytes_to(peer);
//
// Short messages are not counted: the bound on their number is one on their bytes.

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <zmq.hpp>

namespace pizarra::wire {

class UnderWay {
 public:
  static constexpr std::size_t short_message = 4096;

  zmq::message_t message(const std::string& peer, std::string_view frame);
  std::size_t bytes_to(const std::string& peer) const;

 private:
  // ZeroMQ's own thread counts down.
  using Count = std::atomic<std::size_t>;
  struct Counted;
  static void gone(void* data, void* counted);
  std::shared_ptr<Count>& count_of(const std::string& peer);

  std::map<std::string, std::shared_ptr<Count>> counts_;
};

}  // namespace pizarra::wire
