// Publisher and subscribers of one machine, some of them dead, stopped or up to no good.

#include "blackboard/streams/stream_door.hpp"

#include <csignal>
#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>

#include "blackboard/streams/abstract_address.hpp"
#include "blackboard/streams/file_passing.hpp"
#include "blackboard/streams/stream_guest.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/streams/frames.hpp"

namespace pizarra::streams {
namespace {

class StreamDoorTest : public testing::Test {
 protected:
  bool wait_until(const std::function<bool()>& holds) {
    const Time end = executor.now() + 10s;
    executor.call_at(end, [] {});
    executor.run_until([&] { return holds() || executor.now() > end; });
    return holds();
  }
  // A process that subscribes, says so, and receives until it is killed.
  pid_t subscriber_process(const std::string& door) {
    std::array<int, 2> pipe_ends{};
    EXPECT_EQ(pipe(pipe_ends.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
      RealExecutor own;
      const auto guest = StreamGuest::come(
          own, door, "eyes", [](const StreamFrame&) {}, [] {});
      [[maybe_unused]] const ssize_t said = write(pipe_ends[1], "", 1);
      own.run_until([] { return false; });
    }
    close(pipe_ends[1]);
    char said = 0;
    EXPECT_EQ(read(pipe_ends[0], &said, 1), 1);
    close(pipe_ends[0]);
    return child;
  }
  static void end(pid_t child) {
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
  }

  RealExecutor executor;
};

TEST_F(StreamDoorTest, ASubscriberThatDiesIsForgotten) {
  const auto door = StreamDoor::open(executor).value();
  const pid_t child = subscriber_process(door->name());
  EXPECT_TRUE(wait_until([&] { return door->watched("eyes"); }));
  end(child);
  EXPECT_TRUE(wait_until([&] { return !door->watched("eyes"); }));
}

TEST_F(StreamDoorTest, AStoppedSubscriberKeepsNobodyFromAnyFrame) {
  const auto door = StreamDoor::open(executor).value();
  const pid_t child = subscriber_process(door->name());
  EXPECT_TRUE(wait_until([&] { return door->watched("eyes"); }));
  kill(child, SIGSTOP);
  std::uint64_t seen = 0;
  const auto guest = StreamGuest::come(
      executor, door->name(), "eyes", [&](const StreamFrame& frame) { seen = frame.number; }, [] {});
  ASSERT_TRUE(guest.has_value());
  // Frames that grow have a ring each, and it is told of every one.
  bool all = true;
  for (std::uint64_t number = 1; number <= 300; ++number) {
    all = all && wait_until([&] {
            if (seen == 0 || seen + 1 == number)
              door->publish("eyes", numbered_frame(number, static_cast<int>(number), 8));
            return seen == number;
          });
  }
  EXPECT_TRUE(all);
  end(child);
}

TEST_F(StreamDoorTest, APublisherThatIsKilledLeavesNothingAndItsSubscribersHearOfIt) {
  std::array<int, 2> pipe_ends{};
  ASSERT_EQ(pipe(pipe_ends.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    RealExecutor own;
    const auto door = StreamDoor::open(own).value();
    [[maybe_unused]] const ssize_t said = write(pipe_ends[1], door->name().data(), door->name().size());
    std::function<void()> publish = [&] {
      door->publish("eyes", numbered_frame(1, 100, 100));
      own.call_at(own.now() + 1ms, [&] { publish(); });
    };
    publish();
    own.run_until([] { return false; });
  }
  std::array<char, 256> name{};
  const ssize_t length = read(pipe_ends[0], name.data(), name.size());
  close(pipe_ends[0]);
  close(pipe_ends[1]);
  ASSERT_GT(length, 0);
  const std::string door(name.data(), static_cast<std::size_t>(length));
  bool seen = false;
  bool lost = false;
  const auto guest = StreamGuest::come(
      executor, door, "eyes", [&](const StreamFrame&) { seen = true; }, [&] { lost = true; });
  ASSERT_TRUE(guest.has_value());
  EXPECT_TRUE(wait_until([&] { return seen; }));
  end(child);
  EXPECT_TRUE(wait_until([&] { return lost; }));
  const auto late = StreamGuest::come(
      executor, door, "eyes", [](const StreamFrame&) {}, [] {});
  EXPECT_EQ(late.error().symbol, "unreachable");
}

TEST_F(StreamDoorTest, AGuestThatTalksOnIsShownOut) {
  const auto door = StreamDoor::open(executor).value();
  const File socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const AbstractAddress address(door->name());
  ASSERT_EQ(connect(socket.number(), address.get(), address.size()), 0);
  EXPECT_TRUE(send_packet(socket, "eyes"));
  EXPECT_TRUE(wait_until([&] { return door->watched("eyes"); }));
  EXPECT_TRUE(send_packet(socket, "ears"));
  EXPECT_TRUE(wait_until([&] { return !door->watched("eyes"); }));
  EXPECT_FALSE(door->watched("ears"));
}

TEST_F(StreamDoorTest, AnotherUsersProcessIsNotLetInNotEvenByRoot) {
  if (geteuid() != 0) GTEST_SKIP() << "only root can be another user";
  const auto door = StreamDoor::open(executor).value();
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    const File socket(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    const AbstractAddress address(door->name());
    char said = 0;
    const bool went = setuid(nobody) == 0 && connect(socket.number(), address.get(), address.size()) == 0;
    send_packet(socket, "eyes");
    // Nothing comes but the end.
    _exit(went && recv(socket.number(), &said, 1, 0) <= 0 ? 0 : 1);
  }
  const File ended(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  bool gone = false;
  executor.watch_readable(ended.number(), [&] { gone = true; });
  EXPECT_TRUE(wait_until([&] { return gone || door->watched("eyes"); }));
  executor.unwatch_readable(ended.number());
  EXPECT_FALSE(door->watched("eyes"));
  if (!gone) kill(child, SIGKILL);
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(StreamDoorTest, ABellThatSomebodyHasRungFullRingsOnForTheOthers) {
  const auto door = StreamDoor::open(executor).value();
  const File spoiler(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  const AbstractAddress address(door->name());
  ASSERT_EQ(connect(spoiler.number(), address.get(), address.size()), 0);
  ASSERT_TRUE(send_packet(spoiler, "eyes"));
  std::uint64_t seen = 0;
  const auto guest = StreamGuest::come(
      executor, door->name(), "eyes", [&](const StreamFrame& frame) { seen = frame.number; }, [] {});
  ASSERT_TRUE(guest.has_value());
  std::expected<Packet, NoPacket> ring = std::unexpected(NoPacket::yet);
  ASSERT_TRUE(wait_until([&] {
    door->publish("eyes", numbered_frame(1, 4, 4));
    if (!ring) ring = receive_packet(spoiler);
    return seen == 1 && ring;
  }));
  ASSERT_EQ(ring->files.size(), 2U);
  eventfd_t rung = 0;
  ASSERT_EQ(eventfd_read(ring->files[1].number(), &rung), 0);
  ASSERT_EQ(eventfd_write(ring->files[1].number(), ~eventfd_t{1}), 0);
  door->publish("eyes", numbered_frame(2, 4, 4));
  EXPECT_TRUE(wait_until([&] { return seen == 2; }));
  door->publish("eyes", numbered_frame(3, 4, 4));
  EXPECT_TRUE(wait_until([&] { return seen == 3; }));
}

TEST_F(StreamDoorTest, MoreGuestsThanThereIsRoomForAreSentAway) {
  const auto door = StreamDoor::open(executor).value();
  std::vector<std::unique_ptr<StreamGuest>> guests;
  int lost = 0;
  constexpr std::size_t too_many = 3;
  for (std::size_t i = 0; i < StreamDoor::max_guests + too_many; ++i) {
    auto guest = StreamGuest::come(
        executor, door->name(), "eyes", [](const StreamFrame&) {}, [&] { ++lost; });
    ASSERT_TRUE(guest.has_value());
    guests.push_back(std::move(*guest));
    // The kernel keeps only so many that wait to be let in.
    executor.run_until([&, turns = 0]() mutable { return ++turns > 4; });
  }
  EXPECT_TRUE(wait_until([&] { return lost == too_many; }));
}

TEST_F(StreamDoorTest, ADoorThatHandsOutNonsenseIsLeft) {
  const std::string name = "pizarra-test-" + std::to_string(getpid());
  const File listening(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
  const AbstractAddress address(name);
  ASSERT_EQ(bind(listening.number(), address.get(), address.size()), 0);
  ASSERT_EQ(listen(listening.number(), 1), 0);
  bool lost = false;
  const auto guest = StreamGuest::come(
      executor, name, "eyes", [](const StreamFrame&) {}, [&] { lost = true; });
  ASSERT_TRUE(guest.has_value());
  const File accepted(accept4(listening.number(), nullptr, nullptr, SOCK_CLOEXEC));
  const std::array files{listening.number(), listening.number()};
  EXPECT_TRUE(send_packet(accepted, "ring", files));
  EXPECT_TRUE(wait_until([&] { return lost; }));
}

}  // namespace
}  // namespace pizarra::streams
