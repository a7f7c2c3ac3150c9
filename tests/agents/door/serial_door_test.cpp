// Devices on a serial line, which is never closed: what is not understood ends the session, and hello begins another.

#include "drivers/line/pty_wire.hpp"
#include "tests/agents/door/door_fixture.hpp"

namespace pizarra::door {
namespace {

class SerialDoorTest : public DoorTest {
 protected:
  SerialDoorTest() : line_(line::PtyWire::make(executor_).value()) {
    EXPECT_TRUE(run(executor_, line_->open(executor_.now())));
    open_door({.serial = {SerialPlace{line_->path(), 9600}}});
    // Words said before the door has opened the line are lost, as on any line.
    EXPECT_TRUE(run_until(executor_, [this] { return !news_.empty(); }));
  }
  void say(const std::string& text) { ASSERT_TRUE(line_->write(text)); }
  std::string hear() {
    while (!heard_.contains('\n')) {
      const Result<std::string> more = run(executor_, line_->read(executor_.now() + 60s));
      if (!more) return more.error().symbol;
      heard_ += *more;
    }
    const std::size_t end = heard_.find('\n');
    const std::string line = heard_.substr(0, end);
    heard_.erase(0, end + 1);
    return line;
  }
  std::unique_ptr<line::PtyWire> line_;
  std::string heard_;
};

TEST_F(SerialDoorTest, NoiseEndsASessionAndHelloBeginsAnother) {
  EXPECT_EQ(news_.front(), "devices may come over " + line_->path());
  say("\x80\x81 boot v1.2 (\r\n" + hello("barrier") + "\r\n");
  EXPECT_TRUE(hear().starts_with("(closed "));
  EXPECT_EQ(hear(), "(welcome barrier)");
  say("(tell (blocked one))\n(tell (blo");
  EXPECT_TRUE(hear().starts_with("(ok "));
  // It was switched off and on.
  say("\n" + hello("barrier") + "\n(ask (blocked ?b))\n");
  EXPECT_TRUE(hear().starts_with("(closed "));
  EXPECT_EQ(hear(), "(welcome barrier)");
  EXPECT_EQ(hear(), "(ok (blocked one))");
  say("(tell (blocked " + std::string(6000, 'x') + "))\n" + hello("barrier") + "\n");
  EXPECT_TRUE(hear().starts_with("(closed too-long "));
  EXPECT_EQ(hear(), "(welcome barrier)");
}

TEST_F(SerialDoorTest, NobodySpeaksForADeviceWithoutHello) {
  say("(tell (blocked one))\n");
  EXPECT_TRUE(hear().starts_with("(closed malformed "));
  say(hello("barrier") + "\n(shout)\n(tell (blocked one))\n");
  EXPECT_EQ(hear(), "(welcome barrier)");
  EXPECT_TRUE(hear().starts_with("(closed malformed "));
  EXPECT_TRUE(hear().starts_with("(closed malformed "));
  EXPECT_EQ(count("(blocked ?)"), 0U);
}

TEST_F(SerialDoorTest, ALineThatIsNotThereIsWaitedFor) {
  const std::string name = scratch_folder() + "tty";
  open_door({.serial = {SerialPlace{name, 9600}}});
  EXPECT_TRUE(run_until(executor_, [this] { return news_.back().contains("cannot be used as a serial line"); }));
  std::filesystem::create_symlink(line_->path(), name);
  EXPECT_TRUE(run_until(executor_, [&] { return news_.back() == "devices may come over " + name; }));
  say(hello("table") + "\n");
  EXPECT_EQ(hear(), "(welcome table)");
}

}  // namespace
}  // namespace pizarra::door
