#include "programs/command_line/moment.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace pizarra::programs {
namespace {

// In a place that puts its clocks forward in spring.
class MomentTest : public testing::Test {
 protected:
  MomentTest() {
    setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
    tzset();
  }
  // 2026-11-22T13:00:00
  static constexpr Time end{std::chrono::seconds(1'795'348'800)};
  static std::string symbol_of(const std::string& text) {
    const Result<Moment> moment = moment_from_text(text, end);
    return moment ? "ok" : moment.error().symbol;
  }
};

TEST_F(MomentTest, IsARevisionATimeBeforeTheEndALocalTimeOrSecondsOfTheClock) {
  EXPECT_EQ(moment_from_text("120", end).value(), Moment{.revision = 120});
  EXPECT_EQ(moment_from_text("90s", end).value(), Moment{.time = end - 90s});
  EXPECT_EQ(moment_from_text("2d", end).value(), Moment{.time = end - std::chrono::hours(48)});
  EXPECT_EQ(moment_from_text("@12.5", end).value(), Moment{.time = Time(12500ms)});
  const Time noon = end - 3600s;
  EXPECT_EQ(moment_from_text("2026-11-22T12:00:00", end).value(), Moment{.time = noon + 1s - 1us})
      << "to the end of that second";
  EXPECT_EQ(moment_from_text("20000d", Time(5s)).value(), Moment{.time = Time{}}) << "the clock begins at 0";
}

TEST_F(MomentTest, ThatNoCalendarOrClockShowsIsNone) {
  for (const char* text : {"2026-02-30T12:00:00",
                           "2026-02-29T12:00:00",
                           "2026-13-01T12:00:00",
                           "2026-04-31T00:00:00",
                           "2026-11-21T24:00:00",
                           "2026-11-21T23:60:00",
                           "2026-11-21T23:59:60",
                           "2026-03-29T02:30:00",
                           "2026-11-21",
                           "2026-11-21T12:30:00Z",
                           "1960-01-01T00:00:00",
                           "",
                           " ",
                           "-5",
                           "5 s",
                           "5x",
                           "1.5",
                           "s",
                           "@",
                           "@-1",
                           "@inf",
                           "@nan",
                           "@1e300",
                           "99999999999999999999",
                           "18446744073709551615",
                           "9223372036854775808",
                           "4000000000s",
                           "99999999d",
                           "soon",
                           "\xff"}) {
    EXPECT_EQ(symbol_of(text), "bad-moment") << text;
  }
}

TEST_F(MomentTest, ThatIsLaterThanTheEndIsNotYet) {
  EXPECT_EQ(symbol_of("2026-11-22T13:00:00"), "ok");
  EXPECT_EQ(symbol_of("0s"), "ok");
  for (const char* text : {"2026-11-22T13:00:01", "2099-01-01T00:00:00", "@1795348800.1"}) {
    EXPECT_EQ(symbol_of(text), "not-yet") << text;
  }
  const std::string sentence = moment_from_text("2099-01-01T00:00:00", end).error().sentence;
  EXPECT_NE(sentence.find("2026-11-22T13:00:00"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace pizarra::programs
