#include "blackboard/streams/shared_ring.hpp"

#include <atomic>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <random>
#include <sys/mman.h>
#include <thread>

#include "blackboard/streams/frame_text.hpp"
#include "tests/blackboard/streams/frames.hpp"

namespace pizarra::streams {
namespace {

TEST(SharedRing, WhatIsWrittenIsReadWhateverItsSize) {
  std::mt19937 random(7);
  constexpr int longest = 97;
  SharedRing ring = SharedRing::make(longest * longest * 3).value();
  SharedRingView view = SharedRingView::of(ring.file()).value();
  for (std::uint64_t number = 1; number <= 200; ++number) {
    const auto side = [&] { return static_cast<int>(random() % (longest + 1)); };
    const int channels = random() % 2 == 0 ? 1 : 3;
    const StreamFrame frame = numbered_frame(number, side(), side(), channels);
    ring.write(frame);
    const std::optional<StreamFrame> read = view.newest();
    ASSERT_TRUE(read.has_value()) << "frame " << number << ", seed 7";
    EXPECT_EQ(read->number, number);
    EXPECT_EQ(read->captured, frame.captured);
    EXPECT_EQ(read->image->width, frame.image->width);
    EXPECT_EQ(read->image->channels, channels);
    EXPECT_EQ(read->image->pixels, frame.image->pixels);
  }
}

TEST(SharedRing, OnlyTheNewestIsReadAndOnlyOnce) {
  SharedRing ring = SharedRing::make(100).value();
  SharedRingView view = SharedRingView::of(ring.file()).value();
  EXPECT_FALSE(view.newest().has_value());
  for (std::uint64_t number = 1; number <= 9; ++number) ring.write(numbered_frame(number, 10, 10));
  EXPECT_EQ(view.newest()->number, 9U);
  EXPECT_FALSE(view.newest().has_value());
}

TEST(SharedRing, AFrameThatIsKeptStaysAsItIs) {
  SharedRing ring = SharedRing::make(100).value();
  SharedRingView view = SharedRingView::of(ring.file()).value();
  std::vector<StreamFrame> kept;
  for (std::uint64_t number = 1; number <= 9; ++number) {
    ring.write(numbered_frame(number, 10, 10));
    const std::optional<StreamFrame> frame = view.newest();
    if (number % 2 == 0) kept.push_back(*frame);
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].number, 2 * (i + 1));
    EXPECT_TRUE(is_whole(kept[i]));
  }
}

TEST(SharedRing, NoFrameIsAMixtureHoweverFastTheyAreWritten) {
  constexpr std::uint64_t frames = 20'000;
  SharedRing ring = SharedRing::make(64 * 64).value();
  SharedRingView view = SharedRingView::of(ring.file()).value();
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (std::uint64_t number = 1; number <= frames; ++number) ring.write(numbered_frame(number, 64, 64));
    done = true;
  });
  std::uint64_t last = 0;
  bool in_order = true;
  bool whole = true;
  const auto read = [&] {
    const std::optional<StreamFrame> frame = view.newest();
    if (!frame) return;
    whole = whole && is_whole(*frame);
    in_order = in_order && frame->number > last;
    last = frame->number;
  };
  while (!done) read();
  writer.join();
  read();
  EXPECT_TRUE(whole);
  EXPECT_TRUE(in_order);
  EXPECT_EQ(last, frames);
}

TEST(SharedRing, NobodyElseCanWriteIntoItOrShrinkIt) {
  const SharedRing ring = SharedRing::make(100).value();
  const int file = ring.file().number();
  EXPECT_EQ(mmap(nullptr, 64, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0), MAP_FAILED);
  EXPECT_NE(ftruncate(file, 0), 0);
  EXPECT_NE(write(file, "x", 1), 1);
}

TEST(SharedRing, MemoryThatIsNoneIsRefused) {
  const auto memory = [](std::size_t bytes, int seals) {
    File file(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    EXPECT_EQ(ftruncate(file.number(), static_cast<off_t>(bytes)), 0);
    EXPECT_EQ(fcntl(file.number(), F_ADD_SEALS, seals), 0);
    return SharedRingView::of(file);
  };
  EXPECT_EQ(memory(4096, 0).error().sentence, "it may shrink");
  EXPECT_EQ(memory(8, F_SEAL_SHRINK).error().sentence, "it is too short");
  EXPECT_EQ(memory(4096, F_SEAL_SHRINK).error().sentence, "it is not a ring of frames");
  EXPECT_FALSE(SharedRingView::of(File()).has_value());
}

TEST(FrameText, AFrameComesBackAndNothingElseIsOne) {
  const StreamFrame frame = numbered_frame(12, 7, 5, 3);
  const std::string text = frame_to_text("eyes", frame);
  const std::optional<StreamFrame> back = frame_from_text("eyes", text);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->number, 12U);
  EXPECT_TRUE(is_whole(*back));
  EXPECT_FALSE(frame_from_text("eye", text).has_value());
  for (std::size_t length = 0; length < text.size(); ++length) {
    EXPECT_FALSE(frame_from_text("eyes", std::string_view(text).substr(0, length)).has_value()) << length;
  }
  std::string huge = text;
  huge[frame_topic("eyes").size() + 2 * 8 + 6] = 1;  // a width of 2^48
  EXPECT_FALSE(frame_from_text("eyes", huge).has_value());
}

}  // namespace
}  // namespace pizarra::streams
