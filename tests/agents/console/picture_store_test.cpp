// Pictures of the past: which of them a moment finds, which go first, and what is refused.

#include "agents/console/picture_store.hpp"

#include <filesystem>
#include <fstream>

#include "agents/console/picture_keeper.hpp"
#include "lisp/reader.hpp"
#include "tests/agents/console/console_fixture.hpp"
#include "tests/scratch.hpp"

namespace pizarra::console {
namespace {

constexpr std::uintmax_t plenty = 100'000'000;

class PicturesOfThePast : public testing::Test {
 protected:
  PicturesOfThePast() : folder_(scratch_folder() + "pictures") { std::filesystem::remove_all(folder_); }

  std::unique_ptr<PictureStore> open(std::uintmax_t most = plenty) {
    return PictureStore::open(executor_, folder_, most).value();
  }
  static StreamFrame frame(std::uint64_t number, Time captured) {
    auto image = std::make_shared<Image>();
    image->width = 64;
    image->height = 48;
    image->channels = 3;
    image->pixels.assign(64 * 48 * 3, static_cast<std::uint8_t>(number));
    return {.number = number, .captured = captured, .image = image};
  }
  Result<void> keep(PictureStore& store, std::uint64_t number, Time captured, const std::string& stream = "eyes") {
    return run(executor_, store.keep(stream, frame(number, captured)));
  }
  // Its number, or the symbol of the failure.
  std::string found(const PictureStore& store, Time moment, const std::string& stream = "eyes") {
    const auto picture = run(executor_, store.find(stream, moment));
    return picture ? std::to_string(picture->number) : picture.error().symbol;
  }

  RealExecutor executor_;
  const std::string folder_;
};

TEST_F(PicturesOfThePast, FindTheNewestThatWasSeenUntilThen) {
  const auto store = open();
  for (int i = 1; i <= 3; ++i) ASSERT_TRUE(keep(*store, static_cast<std::uint64_t>(i), Time(i * 1s)));
  EXPECT_EQ(found(*store, Time(999ms)), "no-picture");
  EXPECT_EQ(found(*store, Time(1s)), "1");
  EXPECT_EQ(found(*store, Time(2900ms)), "2");
  EXPECT_EQ(found(*store, Time(3s) + PictureStore::longest_gap), "3");
  EXPECT_EQ(found(*store, Time(3s) + PictureStore::longest_gap + 1ms), "no-picture") << "nothing was seen then";
  EXPECT_EQ(found(*store, Time(3s), "others"), "no-picture");
  const auto picture = run(executor_, store->find("eyes", Time(2s)));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->captured, Time(2s));
  EXPECT_EQ(picture->width, 64);
  EXPECT_EQ(picture->height, 48);
  EXPECT_TRUE(picture->jpeg.starts_with("\xff\xd8"));
}

TEST_F(PicturesOfThePast, AreKnownToTheNextConsole) {
  {
    const auto store = open();
    ASSERT_TRUE(keep(*store, 7, Time(7s)));
  }
  std::ofstream(folder_ + "/eyes/8000000_8_64x48.jpg.part") << "half";
  std::ofstream(folder_ + "/eyes/notes.txt") << "a person's";
  const auto store = open();
  EXPECT_EQ(found(*store, Time(9s)), "7");
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/eyes/8000000_8_64x48.jpg.part"));
  EXPECT_TRUE(std::filesystem::exists(folder_ + "/eyes/notes.txt"));
}

TEST_F(PicturesOfThePast, GoTheOldestFirstWhereTheRoomEnds) {
  std::uintmax_t one = 0;
  {
    const auto store = open();
    ASSERT_TRUE(keep(*store, 1, Time(1s)));
    one = store->bytes();
  }
  const auto store = open(3 * one + one / 2);
  for (int i = 2; i <= 9; ++i) {
    ASSERT_TRUE(keep(*store, static_cast<std::uint64_t>(i), Time(i * 1s), i % 2 == 0 ? "left" : "eyes"));
    EXPECT_LE(store->bytes(), 3 * one + one / 2);
  }
  EXPECT_EQ(found(*store, Time(6s), "left"), "no-picture");
  EXPECT_EQ(found(*store, Time(7s)), "7");
  EXPECT_EQ(found(*store, Time(8s), "left"), "8");
  EXPECT_EQ(found(*store, Time(9s)), "9");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) {
    files += entry.path().extension() == ".jpg" ? 1 : 0;
  }
  EXPECT_EQ(files, 3U);
}

TEST_F(PicturesOfThePast, StayWithinTheirFolder) {
  const auto store = open();
  const auto refused = [&](const std::string& stream) { return keep(*store, 1, Time(1s), stream).error().symbol; };
  EXPECT_EQ(refused("../eyes"), "bad-stream");
  EXPECT_EQ(refused(""), "bad-stream");
  EXPECT_EQ(refused(std::string(65, 'x')), "bad-stream");
  for (std::size_t i = 0; i < PictureStore::max_streams; ++i) {
    ASSERT_TRUE(keep(*store, 1, Time(1s), "eyes-" + std::to_string(i)));
  }
  EXPECT_EQ(refused("one-more"), "too-many");
  StreamFrame broken = frame(1, Time(1s));
  const auto image = std::make_shared<Image>(*broken.image);
  image->width = 1000;
  broken.image = image;
  EXPECT_EQ(run(executor_, store->keep("eyes-0", broken)).error().symbol, "bad-image");
}

TEST_F(PicturesOfThePast, BelongToOneConsoleAtATime) {
  const auto store = open();
  const auto second = PictureStore::open(executor_, folder_, plenty);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().symbol, "in-use");
  const auto nowhere = PictureStore::open(executor_, "/proc/none", plenty);
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().symbol, "cannot-write");
}

class KeepingConsole : public ConsoleTest {
 protected:
  KeepingConsole() : folder_(scratch_folder() + "kept") {
    std::filesystem::remove_all(folder_);
    store_ = PictureStore::open(executor_, folder_, plenty).value();
    const std::vector<Relation> streams{stream_relation()};
    EXPECT_TRUE(run(executor_, here_->declare(streams)));
    EXPECT_TRUE(run(executor_, here_->tell(stream_fact("eyes", "left", streams_))));
    reopen([this](Console::Setup& setup) { setup.pictures = store_.get(); });
  }
  ~KeepingConsole() override { console_.reset(); }

  const std::string folder_;
  std::unique_ptr<PictureStore> store_;
};

TEST_F(KeepingConsole, ShowsWhatTheEyesSawThen) {
  executor_.run_until([&] { return streams_.watched("eyes") || tick(); });
  const Time seen = executor_.now();
  auto image = std::make_shared<Image>();
  image->width = 64;
  image->height = 48;
  image->pixels.assign(64 * 48, 90);
  streams_.publish("eyes", {.number = 42, .captured = seen, .image = image});
  executor_.run_until([&] { return store_->bytes() > 0 || tick(); });
  const auto client = page(cookie());
  const auto asked = [&](Time moment) {
    return said(*client, fmt::format("(picture 3 eyes {})", moment.time_since_epoch().count()));
  };
  const std::string line = fmt::format("(picture 3 42 {} 64 48)\n\xff\xd8", seen.time_since_epoch().count());
  EXPECT_TRUE(begins(asked(seen + 1s), line));
  EXPECT_TRUE(has(asked(seen - 1s), "\"symbol\":\"no-picture\""));
}

TEST_F(ConsoleTest, SaysThatItKeepsNoPictures) {
  const auto client = page(cookie());
  EXPECT_TRUE(has(said(*client, "(picture 3 eyes 1000000)"), "this console keeps no pictures"));
}

}  // namespace
}  // namespace pizarra::console
