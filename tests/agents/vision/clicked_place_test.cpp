// Why a click teaches nothing: on ground of every kind, in open contours, at the image's border.

#include "agents/vision/sight/clicked_place.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace pizarra::vision {
namespace {

enum class Ground : std::uint8_t { plain, slope, speckled, grained };

class Clicks : public testing::TestWithParam<std::tuple<int, Ground>> {
 protected:
  int width() const { return std::get<0>(GetParam()); }
  double unit() const { return width() / 320.0; }
  cv::Point at(double x, double y) const { return {cvRound(x * unit()), cvRound(y * unit())}; }

  cv::Mat1f ground(float level) {
    cv::Mat1f out(width() * 3 / 4, width(), level);
    cv::Mat1f specks(out.size());
    random.fill(specks, cv::RNG::NORMAL, 0, 60);
    cv::GaussianBlur(specks, specks, {}, 3);
    for (int y = 0; y < out.rows; ++y) {
      for (int x = 0; x < out.cols; ++x) {
        const float wave = std::sin(0.12F * x / static_cast<float>(unit()) + 2 * std::sin(0.03F * y));
        if (kind() == Ground::slope) out(y, x) *= 1.3F - 0.6F * x / width();
        if (kind() == Ground::speckled) out(y, x) += specks(y, x);
        if (kind() == Ground::grained) out(y, x) += 20 * wave;
      }
    }
    return out;
  }
  // The reason, or "mark".
  std::string click(const cv::Mat1f& drawn, cv::Point where) {
    cv::Mat1f picture;
    cv::GaussianBlur(drawn, picture, {}, 0.8);
    cv::Mat1f grains(picture.size());
    random.fill(grains, cv::RNG::NORMAL, 0, 3);
    cv::Mat1b grey;
    cv::Mat(picture + grains).convertTo(grey, CV_8U);
    const Result<SeenMark> mark = ClickedPlace(grey, where).mark();
    return mark ? "mark" : mark.error().symbol;
  }

  cv::RNG random{3};

 private:
  Ground kind() const { return std::get<1>(GetParam()); }
};

constexpr float light = 170;
constexpr float dark = 30;

TEST_P(Clicks, OnGroundAreToldSo) {
  EXPECT_EQ(click(ground(light), at(160, 120)), "background");
  for (const float card : {dark, 230.F}) {
    cv::Mat1f cards = ground(card == dark ? light : light / 2);
    cv::rectangle(cards, at(40, 60), at(130, 180), card, -1);
    cv::rectangle(cards, at(190, 60), at(280, 180), card, -1);
    EXPECT_EQ(click(cards, at(160, 120)), "background") << "between cards of " << card;
    EXPECT_EQ(click(cards, at(20, 20)), "background") << "beside cards of " << card;
  }
  cv::Mat1f marked = ground(light / 2);
  cv::rectangle(marked, at(90, 60), at(230, 180), 230.F, -1);
  cv::circle(marked, at(160, 120), at(20, 0).x, dark, -1);
  EXPECT_EQ(click(marked, at(160, 85)), "background") << "on the card around the mark";
  EXPECT_EQ(click(marked, at(160, 120)), "mark");
}

TEST_P(Clicks, WithinAnOpenContourAreToldSo) {
  cv::Mat1f open = ground(light);
  cv::circle(open, at(160, 120), at(40, 0).x, dark, -1);
  cv::circle(open, at(160, 120), at(26, 0).x, light, -1);
  cv::rectangle(open, at(160, 108), at(210, 132), light, -1);
  EXPECT_EQ(click(open, at(160, 120)), "open-contour");
  EXPECT_EQ(click(open, at(70, 120)), "background") << "beside it";
}

TEST_P(Clicks, WithinWhatTheBorderCutsAreToldSo) {
  cv::Mat1f cut = ground(light);
  cv::rectangle(cut, at(100, -5), at(220, 110), dark, -1);
  cv::rectangle(cut, at(120, -5), at(200, 90), light, -1);
  EXPECT_EQ(click(cut, at(160, 45)), "border") << "within it";
  EXPECT_EQ(click(cut, at(110, 45)), "border") << "on it";
  EXPECT_EQ(click(cut, at(160, 170)), "background") << "below it";
  cv::Mat1f disc = ground(light);
  cv::circle(disc, at(10, 120), at(30, 0).x, dark, -1);
  EXPECT_EQ(click(disc, at(15, 120)), "border");
}

INSTANTIATE_TEST_SUITE_P(Grounds, Clicks,
                         testing::Combine(testing::Values(320, 640, 1280),
                                          testing::Values(Ground::plain, Ground::slope, Ground::speckled,
                                                          Ground::grained)),
                         [](const auto& one) {
                           return fmt::format("Width{}Kind{}", std::get<0>(one.param),
                                              static_cast<int>(std::get<1>(one.param)));
                         });

}  // namespace
}  // namespace pizarra::vision
