#pragma once

// The common part of all wires over a file descriptor. At most 64 KiB that nobody reads are kept; more breaks the
// connection. A message that the line does not take is lost as a whole. Where it took a part, write() fails, and the
// rest goes before the next message.
//
// Lifecycle: a derived class opens the file and adopts it; close(), or its destruction, closes that. It may adopt
// another one then. The executor outlives it.
//
//   Result<void> sent = wire.write("PP\r\n");
//   Result<std::string> bytes = co_await wire.read(deadline);

#include "blackboard/time/latch.hpp"
#include "drivers/line/byte_wire.hpp"

namespace pizarra::line {

class FileWire : public ByteWire {
 public:
  ~FileWire() override { close(); }
  FileWire(const FileWire&) = delete;
  FileWire& operator=(const FileWire&) = delete;
  void close() override;
  Result<void> write(std::string_view bytes) override;
  Task<Result<std::string>> read(Time deadline) override;

 protected:
  explicit FileWire(Executor& executor) : executor_(executor), arrived_(executor) {}
  // Takes the file, which does not block, over.
  void adopt(int file);
  Executor& executor_;

 private:
  static constexpr std::size_t most_unread = 64 << 10;
  void receive();
  Result<void> put(std::string_view& bytes);
  void lose(std::string why);

  int file_ = -1;
  std::string unread_;
  std::string unsent_;  // of a message that was cut
  std::string why_closed_ = "the line is closed";
  WaitList arrived_;
};

// The text of errno.
std::string system_error();

}  // namespace pizarra::line
