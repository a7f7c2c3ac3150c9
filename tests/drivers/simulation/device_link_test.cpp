#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

#include "blackboard/time/real_executor.hpp"
#include "drivers/simulation/link_server.hpp"
#include "drivers/simulation/socket_link.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/drivers/simulation/bench.hpp"
#include "tests/scratch.hpp"

namespace pizarra::simulation {

namespace {

class DeviceLink : public testing::Test {
 protected:
  DeviceLink() : path_(scratch_folder() + "link"), address_("ipc://" + path_) {}
  ~DeviceLink() override { std::filesystem::remove(path_); }

  std::unique_ptr<LinkServer> serve(World& world) {
    auto server = LinkServer::listen(executor_, context_, address_, world);
    EXPECT_TRUE(server);
    return server ? std::move(*server) : nullptr;
  }

  RealExecutor executor_;
  zmq::context_t context_;
  std::string path_;
  std::string address_;
  const WorldConfig config_ = four_cubes();
};

}  // namespace

TEST_F(DeviceLink, CarriesCallsFailuresAndImages) {
  World world(executor_, config_);
  const auto server = serve(world);
  SocketLink link(executor_, context_, address_);
  SimulatedArm arm(link);
  EXPECT_EQ(run(executor_, arm.start_gripper(10)).error().symbol, "not-in-control");
  EXPECT_TRUE(run(executor_, arm.take_control()));
  const Result<arm::ArmReading> reading = run(executor_, arm.read());
  ASSERT_TRUE(reading);
  EXPECT_EQ(reading->joints, config_.arm.ready);

  SimulatedCamera eyes(executor_, link);
  ASSERT_TRUE(run(executor_, eyes.open()));
  const Result<camera::StereoFrame> first = run(executor_, eyes.next({}, true));
  ASSERT_TRUE(first);
  EXPECT_EQ(first->right->pixels.size(), 320U * 240 * 3);
  const Result<camera::StereoFrame> second = run(executor_, eyes.next(first->captured, false));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->captured - first->captured, 100ms * (second->number - first->number));
}

TEST_F(DeviceLink, AnswersManyCallsAtOnce) {
  World world(executor_, config_);
  const auto server = serve(world);
  SocketLink link(executor_, context_, address_);
  std::vector<std::optional<Result<Message>>> answers(20);
  std::vector<Job> jobs;
  for (auto& answer : answers) {
    jobs.push_back(executor_.spawn(keep(link.call(*read_one("(camera next 0 grey)"), 2s), answer)));
  }
  executor_.run_until([&] { return std::ranges::all_of(answers, [](const auto& a) { return a.has_value(); }); });
  for (const auto& answer : answers) {
    ASSERT_TRUE(*answer);
    EXPECT_EQ((*answer)->images.size(), 2U);
  }
}

TEST_F(DeviceLink, IsDisconnectedWhileTheWorldIsAwayAndComesBack) {
  SocketLink link(executor_, context_, address_);
  const Datum request = *read_one("(arm identify)");
  EXPECT_EQ(run(executor_, link.call(request, 100ms)).error().symbol, "disconnected");
  {
    World world(executor_, config_);
    const auto server = serve(world);
    EXPECT_TRUE(run(executor_, link.call(request, 3s)));
  }
  EXPECT_EQ(run(executor_, link.call(request, 100ms)).error().symbol, "disconnected");
  World world(executor_, config_);
  const auto server = serve(world);
  EXPECT_TRUE(run(executor_, link.call(request, 3s)));
}

TEST_F(DeviceLink, DropsWhatIsNoRequest) {
  World world(executor_, config_);
  const auto server = serve(world);
  zmq::socket_t noise(context_, zmq::socket_type::dealer);
  noise.set(zmq::sockopt::linger, 0);
  noise.connect(address_);
  for (const std::string text : {"", "(", "(call)", "(call x y)", "\xff\xfe", "(call 1 (arm read)) (call"}) {
    noise.send(zmq::buffer(text), zmq::send_flags::none);
  }
  SocketLink link(executor_, context_, address_);
  EXPECT_TRUE(run(executor_, link.call(*read_one("(arm read)"), 3s)));
  EXPECT_EQ(run(executor_, link.call(*read_one("(camera dance)"), 3s)).error().symbol, "bad-request");
}

// An answer may be late: what guards the arm's speed goes by when the arm was so.
TEST(SimulatedArm, SaysWhenItWasAsItReads) {
  Bench bench(four_cubes());
  const std::optional<Time> first = bench.reading().at;
  bench.wait(250ms);
  const std::optional<Time> second = bench.reading().at;
  ASSERT_TRUE(first && second);
  EXPECT_EQ(*second - *first, 250ms);
}

TEST_F(DeviceLink, LeavesNoFileBehindWhenItEnds) {
  World world(executor_, config_);
  auto server = serve(world);
  EXPECT_TRUE(std::filesystem::exists(path_));
  server.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(DeviceLink, SaysWhereItCannotListen) {
  World world(executor_, config_);
  const auto server = LinkServer::listen(executor_, context_, "ipc:///no/such/folder/link", world);
  ASSERT_FALSE(server);
  EXPECT_EQ(server.error().symbol, "bad-address");
}

}  // namespace pizarra::simulation
