#pragma once
// Drag of a held part parallel to the image plane.

#include <utility>

#include "client/app/desk/hand_guide.h"
#include "common/math.h"

namespace prosector {

class PartDrag {
 public:
  /// Pulls the part by `by` m away from the eye with the next call of reach().
  void pull(double by) { pull_ += by; }
  void stop() { pull_ = 0; }
  /// Sets the point (m, world frame) that defines the plane in which the part is dragged.
  void set_anchor(const Vec3& anchor) { anchor_ = anchor; }
  /// Returns the distance, m, along the pointer's ray to the plane through the anchor parallel to the image
  /// plane, increased by the pull. `otherwise`: the distance for a ray that does not approach the plane.
  double reach(const HandGuide& guide, double otherwise) {
    const double towards = -guide.pointer.along.dot(guide.back);
    const double depth = (guide.pointer.from - anchor_).dot(guide.back);
    const double reach = towards > 1e-3 ? depth / towards : otherwise;
    return reach + std::exchange(pull_, 0);
  }

 private:
  Vec3 anchor_ = Vec3::Zero();  // m, world frame
  double pull_ = 0;             // m along the ray, not yet applied to the anchor
};

}  // namespace prosector
