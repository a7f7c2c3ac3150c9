#include "agents/launcher/camera_loss_news.hpp"

#include <gtest/gtest.h>

namespace pizarra::launcher {
namespace {

Datum camera_state(const char* state, const char* trouble) {
  return list("camera-state"_sym, "vision"_sym, Datum::symbol(state), trouble);
}

TEST(CameraLossNews, ALostCameraIsToldOfOnceForEachReasonAndWhenItIsBack) {
  CameraLossNews news;
  EXPECT_EQ(news.sentence_of(camera_state("open", "")), "");
  EXPECT_EQ(news.sentence_of(camera_state("lost", "it is unplugged")), "vision has no images: it is unplugged");
  EXPECT_EQ(news.sentence_of(camera_state("opening", "")), "");
  EXPECT_EQ(news.sentence_of(camera_state("lost", "it is unplugged")), "");
  EXPECT_EQ(news.sentence_of(camera_state("open", "")), "vision has images again");
}

TEST(CameraLossNews, ImagesThatAreLeftOutAreToldOfOnce) {
  CameraLossNews news;
  EXPECT_EQ(news.sentence_of(camera_state("open", "shots/7.png: it ends too early")),
            "vision leaves out images that cannot be read: shots/7.png: it ends too early");
  EXPECT_EQ(news.sentence_of(camera_state("open", "shots/9.png: it ends too early")), "");
}

}  // namespace
}  // namespace pizarra::launcher
