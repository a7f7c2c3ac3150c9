#pragma once

// How far the centre of a mark may be off that a pair of cameras sees for the first time. The sizes with which the
// object was learned say whether it is whole and turned, or covered in part. A whole mark is as large from the front as
// it was learned, both by the plane of its face and by how slim it looks. A covered mark looks turned where its plane
// is not, or has a plane that does not go with how narrow it looks, or is too near for its size.
//
//   const FaceSize now = face_size(model, left, right, front_slimness(object));
//   const double off_px = may_be_off_by_learned_px(object, now, left);

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/sight/whole_face.hpp"

namespace pizarra::vision {

// As one camera alone where one of the sizes is not known.
double may_be_off_by_learned_px(const LearnedObject& object, const FaceSize& now, const SeenMark& left);

// The same by one camera alone, which does not know how far away the mark is: by how slim it looks and, of a triangle,
// by how large. A straight edge that covers a part of a triangle leaves a triangle, as slim as before where the edge
// lies along a side. No other shape keeps its form and slimness. So a triangle that looks smaller than it ever did when
// it was learned is whole and farther away, or covered: nothing tells which.
double may_be_off_by_learned_px(const LearnedObject& object, const SeenMark& left);
// By how large a triangle looks alone; of anything else 0.
double may_be_off_by_size_px(const LearnedObject& object, const SeenMark& left);

}  // namespace pizarra::vision
