#pragma once

// The recorder keeps what the camera saw, with vision's overlays and the story's newest line below: a film of the whole
// run where one is wished for, and a picture of its end.
//
//   Recorder recorder(streams, narrator);
//   Result<void> filming = recorder.film("out/demo.avi");      // cannot-write when no encoder takes the name
//   recorder.watch();                                          // for the picture; film() watches too
//   Result<void> kept = recorder.save_picture("out/demo.png");

#include <memory>
#include <opencv2/videoio.hpp>
#include <string>

#include "blackboard/stream.hpp"
#include "programs/story/narrator.hpp"

namespace pizarra::story {

class Recorder {
 public:
  Recorder(Streams& streams, const Narrator& narrator) : streams_(streams), narrator_(narrator) {}

  // .avi is Motion JPEG, .mp4 MPEG-4; 10 pictures a second, the cell's time.
  Result<void> film(const std::string& path);
  void watch();
  Result<void> save_picture(const std::string& path) const;
  // Ends the film; failure cannot-write when it is not whole.
  Result<void> finish();

 private:
  void take(const StreamFrame& frame);

  Streams& streams_;
  const Narrator& narrator_;
  std::unique_ptr<Streams::Subscription> subscription_;
  std::string film_path_;
  std::unique_ptr<cv::VideoWriter> film_;  // none: no film is wished for
  cv::Mat newest_;
};

}  // namespace pizarra::story
