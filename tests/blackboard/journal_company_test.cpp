// Which transactions a slow disk writes together.

#include <algorithm>
#include <gtest/gtest.h>
#include <utility>

#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/time/virtual_executor.hpp"

namespace pizarra {
namespace {

constexpr Duration disk = 8ms;

class SlowExecutor : public VirtualExecutor {
 public:
  Task<void> offload(std::function<void(const std::function<bool()>&)> work, Duration) override {
    return VirtualExecutor::offload(std::move(work), disk);
  }
};

// Counts the lines of each group.
class CountedLog : public journal::Log {
 public:
  const std::string& path() const override { return path_; }
  Result<std::vector<journal::RememberedReply>> recover(store::Store&) override { return {}; }
  Result<void> append(const journal::JournalGroup& group, bool) override {
    groups.push_back(std::ranges::count(group.lines, '\n'));
    return {};
  }
  journal::JournalRoom room() override { return {.for_all = 1 << 20, .for_removals = 1 << 20}; }
  Result<std::size_t> compact(Time) override { return 0; }
  Result<journal::PlayedBack> read(store::Store&, const Moment&) const override { return journal::PlayedBack{}; }

  std::vector<std::ptrdiff_t> groups;

 private:
  const std::string path_ = "counted";
};

class JournalCompany : public testing::Test {
 protected:
  JournalCompany() {
    // Each who is answered tells again after a while.
    writer_.on_progress = [this] {
      const auto answered = static_cast<int>(writer_.kept() - answered_);
      answered_ = writer_.kept();
      for (int n = 1; n <= answered; ++n) tell_after(n * 5us);
    };
  }
  void tell_after(Duration wait) {
    executor_.call_at(executor_.now() + wait, [this] {
      writer_.append("line");
      writer_.keep();
    });
  }

  SlowExecutor executor_;
  std::shared_ptr<CountedLog> log_ = std::make_shared<CountedLog>();
  journal::JournalWriter writer_{executor_, log_};
  journal::JournalWriter::Position answered_ = 0;
};

TEST_F(JournalCompany, IsNotWaitedForByOneWhoTellsAlone) {
  tell_after(0ms);
  executor_.run_for(1s);
  EXPECT_GE(log_->groups.size(), 124u) << "of 125";
}

TEST_F(JournalCompany, OfThoseWhoBeganOneAfterAnotherIsAllOfThem) {
  for (int n = 0; n < 64; ++n) tell_after(n * 100us);
  executor_.run_for(1s);
  EXPECT_GE(log_->groups.size(), 110u);
  EXPECT_EQ(log_->groups.back(), 64);
}

TEST_F(JournalCompany, ThatStaysAwayIsWaitedForOnce) {
  for (int n = 0; n < 64; ++n) tell_after(0ms);
  executor_.run_for(100ms);
  writer_.on_progress = [this] {
    if (std::exchange(answered_, writer_.kept()) != writer_.kept()) tell_after(5us);
  };
  const std::size_t before = log_->groups.size();
  executor_.run_for(1s);
  EXPECT_GE(log_->groups.size() - before, 123u) << "of 125";
}

}  // namespace
}  // namespace pizarra
