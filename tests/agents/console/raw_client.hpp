#pragma once

// A client that says to the console whatever a test wants said, from a thread of its own: sockets that block, and no
// library that would keep it from being rude.
//
//   RawClient client(port);
//   client.send(request_text(port, "GET", "/", {}));
//   client.read_head();                        // "HTTP/1.1 200 OK ..."
//   client.send_frame(RawClient::text, "(stop 1 \"now\")");
//   std::optional<RawClient::Frame> frame = client.read_frame();     // nothing: the connection is over

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace pizarra::console {

class RawClient {
 public:
  static constexpr int text = 1;
  static constexpr int binary = 2;
  static constexpr int closing = 8;

  struct Frame {
    int kind = 0;
    std::string payload;
    int close_code() const;
  };

  // A small window makes the other side wait sooner.
  explicit RawClient(int port, int receive_bytes = 0);
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient();

  void send(const std::string& bytes);
  void send_frame(int kind, const std::string& payload);
  // To send several at once.
  static std::string frame_of(int kind, const std::string& payload);
  std::string read_head();
  // Waits ten seconds at most, whatever else comes. Stamps, which come whenever they will, are passed over.
  std::optional<Frame> read_frame();
  // The next stamp, other frames passed over; 0 where none comes in that time.
  std::int64_t read_stamp();

 private:
  std::optional<Frame> read_any_frame();
  // Until so many bytes are read; false where they have not come by the deadline.
  bool fill(std::size_t size);

  int file_;
  std::chrono::steady_clock::time_point deadline_;
  std::string read_;
};

using Headers = std::map<std::string, std::string>;

// With the Host and Origin of the console's own page, unless `headers` say others; an empty one is left out.
std::string request_text(int port, const std::string& method, const std::string& path, const Headers& headers);
Headers upgrade_headers(const std::string& cookie);

}  // namespace pizarra::console
