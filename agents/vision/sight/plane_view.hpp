#pragma once

// A mark that one image shows, as the plane of its learned object: registered, and placed in space.
//
//   std::optional<PlaneView> view = view_plane(segmentation.cut(), object, mark);
//   if (view && view->agrees) view->pose = pose_in_plane(model, *view->sample, view->fit);
//   view->fit.in_image({0, 0})           // where the mark's centroid is seen, whatever its tilt

#include "agents/vision/marks/outline_ground.hpp"
#include "agents/vision/objects/plane_look.hpp"
#include "agents/vision/sight/plane_pose.hpp"

namespace pizarra::vision {

struct PlaneView {
  const LearnedSample* sample;
  PlaneFit fit;                   // in the left image
  bool agrees;                    // the edges are those of the outline; else it is something that is like it
  std::optional<PlanePose> pose;  // where they agree, once it was solved
  bool is_part = false;           // something hides the rest: the fit goes by what is seen of the outline
  OutlineGround ground = {};      // of a whole that agrees
  // How far off the centre may be if a part is hidden (whole_outline.hpp).
  std::optional<double> may_be_off_px = {};
  // Where earlier looks have told that it is the object: how much its edges were bent then (off_if_bent_px()).
  std::optional<double> known_bend_px = {};
};

// How the sample's plane lies by the fit in the left image, and by that in the right one where it is there; nothing
// where its size is not known.
std::optional<PlanePose> pose_in_plane(const camera::StereoModel& model, const LearnedSample& sample,
                                       const PlaneFit& left, const PlaneFit* right = nullptr,
                                       const std::optional<cv::Matx33d>& turned_before = {});

// Of its likest sample, without its pose; nothing of a tag, and where there are too few edges.
std::optional<PlaneView> view_plane(const ImageCut& cut, const LearnedObject& object, const SeenMark& mark);

}  // namespace pizarra::vision
