#include "drivers/line/serial_wire.hpp"

#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <termios.h>
#include <unistd.h>

namespace pizarra::line {

namespace {

std::optional<speed_t> speed_of(int baud) {
  switch (baud) {
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return std::nullopt;
  }
}

bool is_pseudo_terminal(int file) {
  constexpr unsigned first_major = 136;  // of Linux' /dev/pts
  constexpr unsigned last_major = 143;
  struct stat about {};
  if (::fstat(file, &about) != 0) return false;
  return major(about.st_rdev) >= first_major && major(about.st_rdev) <= last_major;
}

bool set_up(int file, speed_t speed, Parity parity) {
  termios settings{};
  if (::tcgetattr(file, &settings) != 0) return false;
  ::cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  if (parity == Parity::even) {
    settings.c_cflag |= PARENB;
    settings.c_iflag |= INPCK;
  }
  ::cfsetspeed(&settings, speed);
  bool set = ::tcsetattr(file, TCSANOW, &settings) == 0;
  // No bits go over a pseudo-terminal, and so no parity, which it refuses.
  if (!set && errno == EINVAL && parity != Parity::none && is_pseudo_terminal(file)) {
    settings.c_cflag &= ~static_cast<tcflag_t>(PARENB);
    set = ::tcsetattr(file, TCSANOW, &settings) == 0;
  }
  if (!set) return false;
  return ::tcflush(file, TCIOFLUSH) == 0;
}

}  // namespace

Result<void> check_baud(int baud) {
  if (speed_of(baud)) return {};
  return fail("bad-baud", fmt::format("serial lines do not run at {} baud", baud), to_datum(baud));
}

Result<int> open_serial(const std::string& path, int baud, Parity parity) {
  const Result<void> sound = check_baud(baud);
  if (!sound) return fail(sound);
  const int file = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (file >= 0 && set_up(file, *speed_of(baud), parity)) return file;
  const std::string why = system_error();
  if (file >= 0) ::close(file);
  return fail("disconnected", fmt::format("{} cannot be used as a serial line: {}", path, why), to_datum(path));
}

Task<Result<void>> SerialWire::open(Time) {
  close();
  const Result<int> file = open_serial(path_, baud_, parity_);
  if (!file) co_return fail(file);
  adopt(*file);
  co_return Result<void>();
}

}  // namespace pizarra::line
