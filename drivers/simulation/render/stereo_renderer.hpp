#pragma once

// The pair of images that a snapshot of the cell gives. Parts that have not moved since the last picture are not drawn
// again: the still background is painted once, and of the rest only the rectangle in which something changed.
//
//   StereoRenderer renderer(config, Random(config.seed).split("camera"));
//   StereoPair pair = renderer.render(snapshot, 7, false);

#include <array>
#include <memory>

#include "drivers/simulation/render/bent_image.hpp"
#include "drivers/simulation/render/image_sensor.hpp"
#include "drivers/simulation/render/scene.hpp"

namespace pizarra::simulation {

struct StereoPair {
  std::shared_ptr<const Image> left;
  std::shared_ptr<const Image> right;
};

class StereoRenderer {
 public:
  StereoRenderer(const WorldConfig& config, const Random& random);
  ~StereoRenderer();
  // The same snapshot, camera and frame number give the same pair.
  StereoPair render(const Snapshot& snapshot, const CameraConfig& camera, std::uint64_t frame, bool colour);

 private:
  // The data kept from picture to picture for one side in grey or colour.
  struct View;
  std::shared_ptr<const Image> take(View& view, const Scene& scene, std::uint64_t frame);

  const WorldConfig& config_;
  Random random_;
  std::unique_ptr<ImageSensor> sensor_;  // made with the first picture, as is the next
  std::optional<BentImage> lens_;        // where there is one that bends
  std::array<std::unique_ptr<View>, 4> views_;
};

}  // namespace pizarra::simulation
