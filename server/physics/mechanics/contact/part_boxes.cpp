#include "server/physics/mechanics/contact/part_boxes.h"

#include <limits>

#include "common/assert.h"
#include "server/physics/mechanics/contact/surface_detector.h"

namespace prosector::contact {
namespace {

constexpr double rounding = 1e-9;  // m

/// Returns the half extents of a part's bounding box in room axes, m. An ellipsoid's distance is an estimate,
/// so its box is larger. A mesh's distance is exact only near the mesh, so its box is infinite.
Vec3 half_extents(const collision::ShapePart& part, const Mat3& turned) {
  switch (part.kind) {
    case collision::ShapeKind::sphere:
      return Vec3::Constant(part.half.x());
    case collision::ShapeKind::capsule:
      return part.half.y() * turned.col(1).cwiseAbs() + Vec3::Constant(part.half.x());
    case collision::ShapeKind::cylinder:
      return turned.cwiseAbs() * Vec3(part.half.x(), part.half.y(), part.half.x());
    case collision::ShapeKind::box:
      return turned.cwiseAbs() * part.half;
    case collision::ShapeKind::ellipsoid:
      return Vec3::Constant(part.half.sum());
    case collision::ShapeKind::hull:
    case collision::ShapeKind::triangles:
      break;
  }
  return Vec3::Constant(std::numeric_limits<double>::infinity());
}

}  // namespace

PartBoxes::PartBoxes(const Collider& collider, double margin) {
  PROSECTOR_ASSERT(collider.parts != nullptr && collider.part_poses.size() == collider.parts->size());
  boxes_.reserve(collider.parts->size());
  for (std::size_t i = 0; i < collider.parts->size(); ++i) {
    const Pose pose = collider.pose * collider.part_poses[i];
    const Vec3 half =
        half_extents((*collider.parts)[i], pose.q.toRotationMatrix()).array() + (margin + rounding);
    boxes_.push_back({pose.p - half, pose.p + half});
  }
}

const std::vector<std::uint32_t>& PartBoxes::meeting(const Vec3& lo, const Vec3& hi) {
  found_.clear();
  for (std::uint32_t i = 0; i < boxes_.size(); ++i)
    if (boxes_overlap(boxes_[i].lo, boxes_[i].hi, lo, hi)) found_.push_back(i);
  return found_;
}

}  // namespace prosector::contact
