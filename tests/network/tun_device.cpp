#include "tests/network/tun_device.hpp"

#include <arpa/inet.h>
#include <cstring>
#include <fcntl.h>
#include <linux/if.h>
#include <linux/if_tun.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace pizarra::network {

namespace {

constexpr std::size_t largest_packet = 65'536;

void check(int result, const std::string& what) {
  if (result < 0) throw std::system_error(errno, std::generic_category(), what);
}

// This thread is in that namespace while it lives.
class Inside {
 public:
  explicit Inside(const std::string& name_space) : outside_(open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC)) {
    const int there = open(("/run/netns/" + name_space).c_str(), O_RDONLY | O_CLOEXEC);
    check(there, "/run/netns/" + name_space);
    check(setns(there, CLONE_NEWNET), "setns");
    close(there);
  }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() {
    setns(outside_, CLONE_NEWNET);
    close(outside_);
  }

 private:
  const int outside_;
};

void set_address(ifreq& request, const std::string& address) {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  if (inet_pton(AF_INET, address.c_str(), &name.sin_addr) != 1)
    throw std::system_error(EINVAL, std::generic_category(), address);
  std::memcpy(&request.ifr_addr, &name, sizeof name);
}

void bring_up(ifreq request, const std::string& address) {
  const int socket_file = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  check(socket_file, "socket");
  set_address(request, address);
  check(ioctl(socket_file, SIOCSIFADDR, &request), "SIOCSIFADDR");
  set_address(request, "255.255.255.0");
  check(ioctl(socket_file, SIOCSIFNETMASK, &request), "SIOCSIFNETMASK");
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  check(ioctl(socket_file, SIOCSIFFLAGS, &request), "SIOCSIFFLAGS");
  close(socket_file);
}

}  // namespace

TunDevice::TunDevice(const std::string& name_space, const std::string& address) {
  const Inside inside(name_space);
  file_ = open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK);
  check(file_, "/dev/net/tun");
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  std::strncpy(static_cast<char*>(request.ifr_name), "pz0", IFNAMSIZ - 1);
  check(ioctl(file_, TUNSETIFF, &request), "TUNSETIFF");
  bring_up(request, address);
}

TunDevice::~TunDevice() {
  if (file_ >= 0) close(file_);
}

std::optional<Packet> TunDevice::read() const {
  Packet packet(largest_packet);
  const ssize_t size = ::read(file_, packet.data(), packet.size());
  if (size <= 0) return std::nullopt;
  packet.resize(static_cast<std::size_t>(size));
  return packet;
}

void TunDevice::write(const Packet& packet) const {
  [[maybe_unused]] const ssize_t written = ::write(file_, packet.data(), packet.size());
}

}  // namespace pizarra::network
