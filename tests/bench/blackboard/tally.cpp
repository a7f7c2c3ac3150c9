#include "tests/bench/blackboard/tally.hpp"

#include <algorithm>
#include <new>
#include <poll.h>
#include <stdexcept>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/bench/blackboard/board_process.hpp"

namespace pizarra::bench {

Tally::Tally() : whole_(eventfd(0, EFD_CLOEXEC)) {
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED || whole_ < 0) throw std::runtime_error("no memory to share");
  shared_ = new (memory) Shared{};
}

Tally::~Tally() {
  munmap(shared_, sizeof(Shared));
  close(whole_);
}

void Tally::received(std::size_t subscriber, std::uint64_t number) {
  Frame& here = frame(number);
  here.received_us[subscriber] = now_us();
  if (here.count.fetch_add(1) + 1 == shared_->expected) eventfd_write(whole_, 1);
}

void Tally::sent(std::uint64_t number) {
  frame(number).count = 0;
  frame(number).sent_us = now_us();
}

void Tally::await(std::uint64_t number) {
  constexpr int patience_ms = 10'000;
  while (frame(number).count < shared_->expected) {
    pollfd waiting{whole_, POLLIN, 0};
    if (poll(&waiting, 1, patience_ms) != 1) throw std::runtime_error("a frame did not reach everybody");
    eventfd_t count = 0;
    eventfd_read(whole_, &count);
  }
}

double Tally::last_us(std::uint64_t number) const {
  double last = 0;
  for (std::size_t i = 0; i < max_subscribers; ++i) last = std::max(last, took_us(i, number));
  return last;
}

double Tally::took_us(std::size_t subscriber, std::uint64_t number) const {
  return frame(number).received_us[subscriber] - frame(number).sent_us;
}

}  // namespace pizarra::bench
