#pragma once

// Tells what the eyes are doing, for whom, and how their camera is.
//
//   StateTeller state(camera, feed, holders, tracker, pictures, facts);
//   co_await state.tell();                       // something of it has changed
//   if (state.has_news()) co_await state.tell();   // the camera has dropped frames since
//   state.mode();                                // "tracking"

#include "agents/vision/agent/camera_feed.hpp"
#include "agents/vision/agent/fact_teller.hpp"
#include "agents/vision/agent/mode_holders.hpp"
#include "agents/vision/agent/picture_streams.hpp"
#include "agents/vision/sight/mark_tracker.hpp"

namespace pizarra::vision {

class StateTeller {
 public:
  // All outlive it.
  StateTeller(camera::StereoCamera& camera, const CameraFeed& feed, const ModeHolders& holders,
              const MarkTracker& tracker, const PictureStreams& pictures, FactTeller& facts)
      : camera_(camera), feed_(feed), holders_(holders), tracker_(tracker), pictures_(pictures), facts_(facts) {}

  // idle, capturing, learning, finding, tracking
  std::string_view mode() const;
  Task<void> tell();
  // Only which client holds which mode.
  Task<void> tell_holders();
  bool has_news() const { return told_drops_ != camera_.drops(); }

 private:
  Task<void> tell_streams();

  camera::StereoCamera& camera_;
  const CameraFeed& feed_;
  const ModeHolders& holders_;
  const MarkTracker& tracker_;
  const PictureStreams& pictures_;
  FactTeller& facts_;
  camera::CameraDrops told_drops_;
  std::vector<Datum> told_held_;
};

}  // namespace pizarra::vision
