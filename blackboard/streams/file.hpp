#pragma once

// An open file descriptor, closed with this object.
//
//   File socket(::socket(AF_UNIX, SOCK_SEQPACKET, 0));
//   if (!socket) return fail(...);
//   bind(socket.number(), ...);

#include <unistd.h>
#include <utility>

namespace pizarra::streams {

class File {
 public:
  File() = default;
  explicit File(int number) : number_(number) {}
  File(File&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  File& operator=(File&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~File() {
    if (number_ >= 0) close(number_);
  }
  explicit operator bool() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_ = -1;
};

}  // namespace pizarra::streams
