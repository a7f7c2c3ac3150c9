#pragma once

// The images that others may watch, each a stream of its own: the pair as the camera gives it, the eyes' grey, the same
// in colour, and what a person likes to see. An image is made only while somebody watches it.
//
//   PictureStreams pictures(context, camera, &streams);
//   pictures.publish(frame);                                                  // the camera's and the grey one
//   if (pictures.person_watches()) pictures.show(frame, annotation);           // the others
//   pictures.stop();              // before it is destroyed, where a picture may be in hand

#include "agents/runtime/agent.hpp"
#include "agents/vision/sight/annotate.hpp"
#include "blackboard/stream.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

class PictureStreams {
 public:
  // Everything outlives it. `streams` may be null: nothing is shown then.
  PictureStreams(runtime::AgentContext& context, camera::StereoCamera& camera, Streams* streams)
      : context_(context), camera_(camera), streams_(streams) {}

  // (stream NAME KIND PLACE) of each.
  std::vector<Datum> facts() const;
  void publish(const camera::StereoFrame& frame);
  bool person_watches() const;
  // In colour only where the frame before has been shown. The status gets the number of the frame that is shown.
  void show(const camera::StereoFrame& frame, const Annotation& annotation);
  void stop() { showing_ = Job(); }

 private:
  std::string name_of(std::string_view kind) const;
  bool watched(std::string_view kind) const;
  Task<void> show_in_colour(camera::StereoFrame frame, Annotation annotation, bool annotated);
  void publish_annotated(const camera::StereoFrame& shown, Annotation annotation);

  runtime::AgentContext& context_;
  camera::StereoCamera& camera_;
  Streams* streams_;
  Job showing_;
};

}  // namespace pizarra::vision
