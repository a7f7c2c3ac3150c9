#include "drivers/line/pty_wire.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

namespace pizarra::line {

Result<std::unique_ptr<PtyWire>> PtyWire::make(Executor& executor) {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  char name[64];
  int slave = -1;
  if (master >= 0 && ::grantpt(master) == 0 && ::unlockpt(master) == 0 && ::ptsname_r(master, name, sizeof name) == 0) {
    slave = ::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC);
  }
  termios settings{};
  if (slave < 0 || ::tcgetattr(slave, &settings) != 0) {
    const std::string why = system_error();
    if (slave >= 0) ::close(slave);
    if (master >= 0) ::close(master);
    return fail("no-terminal", "no pseudo-terminal can be opened: " + why);
  }
  ::cfmakeraw(&settings);
  ::tcsetattr(slave, TCSANOW, &settings);
  return std::unique_ptr<PtyWire>(new PtyWire(executor, master, slave, name));
}

PtyWire::PtyWire(Executor& executor, int master, int slave, std::string path)
    : FileWire(executor), master_(master), slave_(slave), path_(std::move(path)) {}

PtyWire::~PtyWire() {
  close();
  ::close(slave_);
  ::close(master_);
}

Task<Result<void>> PtyWire::open(Time) {
  close();
  const int file = ::fcntl(master_, F_DUPFD_CLOEXEC, 0);
  if (file < 0) co_return fail("disconnected", "the pseudo-terminal cannot be used: " + system_error());
  adopt(file);
  co_return Result<void>();
}

}  // namespace pizarra::line
