// pizarra-links: the cables and the switch between hosts that are network namespaces. Each host gets a network card,
// and every packet that it sends comes through here, where it is delayed, lost, slowed down or cut off.
//
//   pizarra-links [--seed N] NAME=NAMESPACE=ADDRESS ...       (as root; answers `ready`)
//
// Then lines on its standard input, each answered by `ok` or `error: ...`:
//
//   NAME both|out|in [delay MS] [loss PERCENT] [rate KBIT/S] [cut]
//
// `out` is what the host sends, `in` what it receives; what is not said is as on a good link. It ends with its standard
// input.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <poll.h>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

#include "tests/network/packet_line.hpp"
#include "tests/network/tun_device.hpp"

namespace pizarra::network {
namespace {

struct Host {
  std::string name;
  std::array<std::uint8_t, 4> address;
  std::unique_ptr<TunDevice> card;
  PacketLine out;
  PacketLine in;
};

std::array<std::uint8_t, 4> address_from(const std::string& text) {
  std::array<std::uint8_t, 4> address{};
  std::istringstream in(text);
  std::string part;
  for (std::uint8_t& byte : address) {
    std::getline(in, part, '.');
    byte = static_cast<std::uint8_t>(std::stoi(part));
  }
  return address;
}

class Links {
 public:
  void add(const std::string& word, std::uint64_t seed) {
    const std::size_t first = word.find('=');
    const std::size_t second = word.find('=', first + 1);
    const std::string address = word.substr(second + 1);
    const std::string name_space = word.substr(first + 1, second - first - 1);
    hosts_.push_back({word.substr(0, first), address_from(address), std::make_unique<TunDevice>(name_space, address),
                      PacketLine(2 * seed), PacketLine(2 * seed + 1)});
  }

  void run() {
    while (true) {
      std::vector<pollfd> files = {{STDIN_FILENO, POLLIN, 0}};
      for (const Host& host : hosts_) files.push_back({host.card->file(), POLLIN, 0});
      const timespec until_due = time_left();
      ppoll(files.data(), files.size(), &until_due, nullptr);
      if (files[0].revents != 0 && !hear_commands()) return;
      for (Host& host : hosts_) {
        for (int some = 0; some < 64; ++some) {
          std::optional<Packet> packet = host.card->read();
          if (!packet) break;
          host.out.take(std::move(*packet), std::chrono::steady_clock::now());
        }
      }
      forward();
    }
  }

 private:
  timespec time_left() const {
    std::optional<Moment> soonest;
    const auto note = [&](std::optional<Moment> due) {
      if (due && (!soonest || *due < *soonest)) soonest = due;
    };
    for (const Host& host : hosts_) {
      note(host.out.next());
      note(host.in.next());
    }
    const auto left = soonest ? *soonest - std::chrono::steady_clock::now() : std::chrono::seconds(1);
    const auto ns = std::max<std::int64_t>(0, std::chrono::nanoseconds(left).count());
    return {ns / 1'000'000'000, ns % 1'000'000'000};
  }

  // From its host's line to the other's.
  void forward() {
    const Moment now = std::chrono::steady_clock::now();
    for (Host& from : hosts_) {
      while (std::optional<Packet> packet = from.out.give(now)) {
        Host* to = find(*packet);
        if (to != nullptr) to->in.take(std::move(*packet), now);
      }
    }
    for (Host& to : hosts_) {
      while (const std::optional<Packet> packet = to.in.give(now)) to.card->write(*packet);
    }
  }

  Host* find(const Packet& packet) {
    constexpr std::size_t destination = 16;
    const bool ipv4 = packet.size() >= 20 && packet[0] >> 4 == 4;
    const auto is_for = [&](const Host& host) {
      return std::equal(host.address.begin(), host.address.end(), packet.begin() + destination);
    };
    const auto found = ipv4 ? std::ranges::find_if(hosts_, is_for) : hosts_.end();
    return found == hosts_.end() ? nullptr : &*found;
  }

  bool hear_commands() {
    char bytes[4096];
    const ssize_t size = read(STDIN_FILENO, bytes, sizeof bytes);
    if (size <= 0) return false;
    heard_.append(bytes, static_cast<std::size_t>(size));
    for (std::size_t end = heard_.find('\n'); end != std::string::npos; end = heard_.find('\n')) {
      std::cout << obey(heard_.substr(0, end)) << std::endl;
      heard_.erase(0, end + 1);
    }
    return true;
  }

  std::string obey(const std::string& line) {
    std::istringstream in(line);
    std::string name;
    std::string direction;
    in >> name >> direction;
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    const auto host = std::ranges::find(hosts_, name, &Host::name);
    const std::optional<LineConditions> conditions = LineConditions::from(words);
    const bool known = direction == "both" || direction == "out" || direction == "in";
    if (host == hosts_.end() || !known || !conditions) return "error: this is not understood: " + line;
    if (direction != "in") host->out.set(*conditions);
    if (direction != "out") host->in.set(*conditions);
    return "ok";
  }

  std::vector<Host> hosts_;
  std::string heard_;
};

int run(const std::vector<std::string>& words) {
  std::uint64_t seed = 1;
  Links links;
  try {
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == "--seed" && i + 1 < words.size()) {
        seed = std::stoull(words[++i]);
      } else if (std::ranges::count(words[i], '=') == 2) {
        links.add(words[i], seed++);
      } else {
        fmt::print(stderr, "usage: pizarra-links [--seed N] NAME=NAMESPACE=ADDRESS ...\n");
        return 2;
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "pizarra-links: {}\n", error.what());
    return 1;
  }
  std::cout << "ready" << std::endl;
  links.run();
  return 0;
}

}  // namespace
}  // namespace pizarra::network

int main(int argc, char** argv) { return pizarra::network::run({argv + 1, argv + argc}); }
