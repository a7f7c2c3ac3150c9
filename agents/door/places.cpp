#include "agents/door/places.hpp"

#include <arpa/inet.h>
#include <optional>

#include "lisp/plain_text.hpp"

namespace pizarra::door {

namespace {

std::unexpected<Failure> bad_address(const std::string& text, const char* usage) {
  return fail("bad-address", std::string("that is no place for devices: ") + usage, to_datum(text));
}

}  // namespace

Result<TcpPlace> tcp_place_from(const std::string& text) {
  constexpr const char* usage = "127.0.0.1:PORT";
  constexpr std::uint32_t loopback_network = 127;
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return bad_address(text, usage);
  const auto port = number_from<std::uint16_t>(std::string_view(text).substr(colon + 1));
  std::string address = text.substr(0, colon);
  if (address == "localhost") address = "127.0.0.1";
  in_addr number{};
  if (!port || ::inet_pton(AF_INET, address.c_str(), &number) != 1) return bad_address(text, usage);
  if (ntohl(number.s_addr) >> 24 != loopback_network) {
    return fail("not-loopback",
                "devices come over this machine's loopback alone, because what they say is not encrypted: 127.0.0.1",
                to_datum(text));
  }
  return TcpPlace{std::move(address), *port};
}

Result<SerialPlace> serial_place_from(const std::string& text) {
  if (!text.starts_with('/')) return bad_address(text, "/dev/NAME, or /dev/NAME:BAUD");
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return SerialPlace{text};
  const auto baud = number_from<int>(std::string_view(text).substr(colon + 1));
  // Names of devices may have colons, as those of /dev/serial/by-path.
  if (!baud) return SerialPlace{text};
  return SerialPlace{text.substr(0, colon), *baud};
}

}  // namespace pizarra::door
