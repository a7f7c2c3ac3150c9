#include "programs/commands/log_meeting.hpp"

#include "drivers/line/tcp_wire.hpp"

namespace pizarra::programs {

namespace {

struct Place {
  std::string host;
  std::uint16_t port = 0;
};

Place place_of(const std::string& member) {
  const std::size_t colon = member.rfind(':');
  const std::string host = member.substr(0, colon);
  return {host == "localhost" ? "127.0.0.1" : host, static_cast<std::uint16_t>(std::stoi(member.substr(colon + 1)))};
}

}  // namespace

Result<std::unique_ptr<LogMeeting>> LogMeeting::open(Executor& executor, const std::string& own,
                                                     const std::string& cell) {
  const Place place = place_of(own);
  Result<std::unique_ptr<line::TcpPort>> port = line::TcpPort::listen(executor, place.host, place.port);
  if (!port) return fail(port);
  return std::unique_ptr<LogMeeting>(new LogMeeting(executor, std::move(*port), cell));
}

Task<void> LogMeeting::say() {
  while (true) {
    const Result<void> came = co_await port_->open(executor_.now() + std::chrono::hours(1));
    if (came) (void)port_->write(sentence_);
    port_->close();
  }
}

Task<bool> LogMeeting::says_it(std::string member) {
  const Place place = place_of(member);
  line::TcpWire wire(executor_, place.host, place.port);
  const Time deadline = executor_.now() + 500ms;
  const Result<void> opened = co_await wire.open(deadline);
  if (!opened) co_return false;
  std::string said;
  while (said.size() < sentence_.size()) {
    const Result<std::string> more = co_await wire.read(deadline);
    if (!more) co_return false;
    said += *more;
  }
  co_return said == sentence_;
}

}  // namespace pizarra::programs
