#include "drivers/simulation/render/stereo_renderer.hpp"

#include <algorithm>

#include "drivers/simulation/render/paint_order.hpp"

namespace pizarra::simulation {

namespace {

using Corners = std::vector<Eigen::Vector2d>;

const Colour backdrop_top(196, 186, 172);
const Colour backdrop_bottom(142, 132, 120);
constexpr float shadow_dark = 0.3F;
constexpr double shadow_softness_px = 3;

Canvas paint_background(const Eye& eye, const WorldConfig& config, int channels) {
  Canvas canvas(eye.width, eye.height, channels);
  for (int y = 0; y < eye.height; ++y) {
    const Colour colour = backdrop_top + (backdrop_bottom - backdrop_top) * (static_cast<float>(y) / eye.height);
    for (int x = 0; x < eye.width; ++x) {
      for (int c = 0; c < channels; ++c) canvas.at(x, y)[c] = channels == 1 ? grey_of(colour) : colour[c];
    }
  }
  if (config.background) {
    const double beyond = 1;  // the borders' own pixels are covered wholly
    const Outline all(Corners{{-beyond, -beyond},
                              {eye.width + beyond, -beyond},
                              {eye.width + beyond, eye.height + beyond},
                              {-beyond, eye.height + beyond}});
    paint(canvas, SeenPhotograph(eye, behind_the_table(config)), all, canvas.rect());
  }
  for (const Solid& solid : still_solids(config)) paint(canvas, see(eye, solid), canvas.rect());
  return canvas;
}

// Where two lists of outlines differ.
Rect difference(const std::vector<Corners>& before, const std::vector<Corners>& after) {
  Rect changed;
  for (std::size_t i = 0; i < std::max(before.size(), after.size()); ++i) {
    if (i < before.size() && i < after.size() && before[i] == after[i]) continue;
    if (i < before.size()) changed = changed.united(rect_around(before[i]));
    if (i < after.size()) changed = changed.united(rect_around(after[i]));
  }
  return changed;
}

std::vector<Outline> on_table(const Eye& eye, const Scene& scene) {
  std::vector<Outline> out;
  for (const Points& shadow : scene.hard_shadows) out.emplace_back(see(eye, shadow));
  return out;
}

std::vector<Corners> see_hard_shadows(const Eye& eye, const Scene& scene) {
  std::vector<Corners> out;
  for (const Points& shadow : scene.hard_shadows) out.push_back(see(eye, shadow));
  for (const Solid& solid : scene.solids) {
    for (const Face& face : solid.faces) {
      for (const Points& shadow : face.shadows) out.push_back(see(eye, shadow));
    }
  }
  return out;
}

// What is painted before the lens bends it.
Eye eye_before(const CameraConfig& camera, const std::optional<BentImage>& lens, Side side) {
  CameraConfig pinhole = camera;
  if (lens) pinhole.model = lens->straight();
  return make_eye(pinhole, side);
}

}  // namespace

struct StereoRenderer::View {
  View(const WorldConfig& config, const CameraConfig& camera, const std::optional<BentImage>& lens, Side which,
       bool colour)
      : side(which),
        pose(camera.pose),
        turn(camera.turn),
        eye(eye_before(camera, lens, which)),
        background(paint_background(eye, config, colour ? 3 : 1)),
        canvas(background),
        exposure(canvas) {
    if (!lens) return;
    bent.emplace(camera.model.width, camera.model.height, canvas.channels);
    exposure = Exposure(*bent);
  }

  const Canvas& picture() const { return bent ? *bent : canvas; }

  Side side;
  forms::CameraPose pose;
  ptu::HeadTurn turn;
  Eye eye;
  Canvas background;
  Canvas canvas;               // as a pinhole camera sees
  std::optional<Canvas> bent;  // by the lens
  Exposure exposure;
  bool exposed = false;
  std::vector<Corners> solids;  // as last painted
  std::vector<Corners> shadows;
  std::vector<Corners> hard_shadows;  // on the table, and on what stands there
};

StereoRenderer::StereoRenderer(const WorldConfig& config, const Random& random) : config_(config), random_(random) {}

StereoRenderer::~StereoRenderer() = default;

std::shared_ptr<const Image> StereoRenderer::take(View& view, const Scene& scene, std::uint64_t frame) {
  std::vector<Corners> solids;
  std::vector<Corners> shadows;
  std::vector<Corners> hard_shadows = see_hard_shadows(view.eye, scene);
  for (const Solid& solid : scene.solids) solids.push_back(see(view.eye, solid.vertices));
  for (const Points& shadow : scene.shadows) shadows.push_back(see(view.eye, shadow));
  const int soft = static_cast<int>(shadow_softness_px) + 1;
  const Rect moved_shadows = difference(view.shadows, shadows);
  Rect changed = difference(view.solids, solids).united(difference(view.hard_shadows, hard_shadows));
  if (!moved_shadows.empty()) changed = changed.united(moved_shadows.grown(soft));
  if (!view.exposed) changed = view.canvas.rect();
  changed = changed.empty() ? changed : sensor_->needed(changed).intersected(view.canvas.rect());
  view.exposed = true;
  view.solids = std::move(solids);
  view.shadows = std::move(shadows);
  view.hard_shadows = std::move(hard_shadows);

  if (!changed.empty()) {
    const Rect area = sensor_->needed(changed).intersected(view.canvas.rect());
    for (int y = area.top; y < area.bottom; ++y) {
      const float* from = view.background.at(area.left, y);
      std::copy(from, from + (area.right - area.left) * view.canvas.channels, view.canvas.at(area.left, y));
    }
    for (const Corners& shadow : view.shadows) {
      const Rect within = rect_around(shadow).grown(soft).intersected(area);
      if (!within.empty()) shade(view.canvas, Outline(shadow), shadow_dark, shadow_softness_px, within);
    }
    const std::vector<Outline> hard = on_table(view.eye, scene);
    if (!hard.empty()) shade(view.canvas, hard, scene.hard_shadow_dark, area);
    std::vector<SeenSolid> seen;
    for (const Solid& solid : scene.solids) seen.push_back(see(view.eye, solid));
    for (const std::size_t index : paint_order(view.eye, scene.solids, seen)) paint(view.canvas, seen[index], area);
    Rect shown = changed;
    if (view.bent) {
      shown = lens_->showing(area);
      lens_->bend(view.canvas, shown, *view.bent);
      shown = sensor_->needed(shown);
    }
    sensor_->expose(view.picture(), shown, view.exposure);
  }
  return std::make_shared<const Image>(sensor_->develop(view.exposure, view.picture(), frame, view.side));
}

StereoPair StereoRenderer::render(const Snapshot& snapshot, const CameraConfig& camera, std::uint64_t frame,
                                  bool colour) {
  if (!sensor_) {
    sensor_ = std::make_unique<ImageSensor>(config_.camera, random_);
    if (config_.camera.bends()) lens_.emplace(config_.camera);
  }
  const Scene scene = moving_scene(config_, snapshot);
  const std::size_t first = colour ? 2 : 0;
  for (const Side side : {Side::left, Side::right}) {
    auto& view = views_[first + static_cast<std::size_t>(side)];
    // A camera that has turned sees all anew.
    if (!view || view->pose != camera.pose || view->turn != camera.turn)
      view = std::make_unique<View>(config_, camera, lens_, side, colour);
  }
  return {take(*views_[first], scene, frame), take(*views_[first + 1], scene, frame)};
}

}  // namespace pizarra::simulation
