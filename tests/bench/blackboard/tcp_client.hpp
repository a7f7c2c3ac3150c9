#pragma once

// A connection to a peer's server on this machine, read by lines and by bytes.
//
//   const int port = free_port();          // for a server to be started
//   TcpClient client(port, "redis");
//   client.send("PING\r\n");
//   client.line();                         // without its end

#include <string>
#include <string_view>

namespace pizarra::bench {

// Until a server that was just started listens there; within ten seconds, or the bench ends.
void wait_for_server(int port, const std::string& name);

class TcpClient {
 public:
  TcpClient(int port, std::string server);
  TcpClient(const TcpClient&) = delete;
  TcpClient& operator=(const TcpClient&) = delete;
  ~TcpClient();

  void send(std::string_view text) const;
  // Both are valid until the next is read.
  std::string_view line();
  std::string_view bytes(std::size_t count);

 private:
  void read_more();

  const std::string server_;
  const int file_;
  std::string buffer_;
  std::size_t read_ = 0;  // of the buffer
};

}  // namespace pizarra::bench
