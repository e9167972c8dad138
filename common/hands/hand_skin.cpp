#include "common/hands/hand_skin.h"

#include <algorithm>
#include <cmath>

#include "common/anatomy/isosurface.h"
#include "common/hands/hand_field.h"
#include "common/ids.h"
#include "common/smooth_normals.h"

namespace prosector {
namespace {

constexpr double skin_cell = 0.0055;  // m: edge length of the triangles, about

/// Returns the index of the finger's first joint in hand order; the thumb has two joints.
std::size_t first_joint(std::size_t finger) {
  return finger == 0 ? 0 : 2 + 3 * (finger - 1);
}
std::size_t joints_of(std::size_t finger) {
  return finger == 0 ? 2 : 3;
}

/// Returns the surface of the right hand, extracted from a field stretched in width. The stretch makes the
/// gaps between the fingers wide enough for the lattice to separate them.
TriangleMesh right_hand_surface() {
  constexpr double stretch = 1.8;
  const SolidField stretched{[](const Vec3& x) {
                               return hand_field({x.x() / stretch, x.y(), x.z()}).solid;
                             },
                             {{-0.10 * stretch, -0.035, -0.205}, {0.06 * stretch, 0.03, 0.065}}};
  TriangleMesh mesh = isosurface(stretched, skin_cell);
  for (Vec3& x : mesh.positions) x.x() /= stretch;
  return mesh;
}

double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Position and axis of a joint in the open hand, and its rotation angle.
struct Hinge {
  Eigen::Vector3f origin, axis;
  float angle;
};

std::array<Hinge, hand_joints> hinges_of(std::size_t hand, const std::array<double, fingers>& flexion) {
  const auto open = hand_pose(hand, {});
  const auto angles = joint_angles(flexion);
  std::array<Hinge, hand_joints> out;
  for (std::size_t j = 0; j < hand_joints; ++j)
    out[j] = {open[j].p.cast<float>(), (open[j].q * -Vec3::UnitX()).cast<float>(),
              static_cast<float>(angles[j])};
  return out;
}

}  // namespace

HandSkin::HandSkin(std::size_t hand) : hand_(right_hand) {
  const TriangleMesh mesh = right_hand_surface();
  for (const Vec3& x : mesh.positions) {
    weigh(x);
    rest_.push_back(x.cast<float>());
  }
  triangles_ = mesh.triangles;
  if (hand == left_hand) *this = mirrored();
}

HandSkin HandSkin::mirrored() const {
  HandSkin out = *this;
  out.hand_ = hand_ == left_hand ? right_hand : left_hand;
  for (Eigen::Vector3f& x : out.rest_) x.x() = -x.x();
  for (auto& t : out.triangles_) std::swap(t[1], t[2]);
  return out;
}

std::array<HandSkin, 2> make_hand_skins() {
  const HandSkin right(right_hand);
  return {right.mirrored(), right};
}

void HandSkin::weigh(const Vec3& x) {
  static const auto open = hand_pose(right_hand, {});
  const auto& segments = hand_segments(right_hand);
  const HandField field = hand_field(x);
  const double nearest = *std::min_element(field.finger.begin(), field.finger.end());
  constexpr double border = 0.002;  // m: width over which neighbouring fingers share the skin between them
  double total = 0;
  for (const double f : field.finger) total += std::exp((nearest - f) / border);

  Vertex vertex{static_cast<std::uint32_t>(influences_.size()), 0};
  for (std::size_t finger = 0; finger < fingers; ++finger) {
    const double share = std::exp((nearest - field.finger[finger]) / border) / total;
    if (share < 1e-3) continue;
    Influence influence{static_cast<std::uint8_t>(finger), static_cast<float>(share), {}};
    // The palm's own flesh doesn't move.
    const double near = 1 - smooth_step(0.001, 0.012, field.finger[finger]);
    for (std::size_t k = 0; k < joints_of(finger); ++k) {
      const std::size_t joint = first_joint(finger) + k;
      const double ahead = -(open[joint].inverse() * x).z() / segments[joint].radius;
      influence.turned[k] = static_cast<float>(near * smooth_step(-1.0, 1.0, ahead));
    }
    influences_.push_back(influence);
    ++vertex.count;
  }
  // Renormalises the shares, since those below the cut-off were dropped.
  float kept = 0;
  for (std::uint32_t k = 0; k < vertex.count; ++k) kept += influences_[vertex.first + k].share;
  for (std::uint32_t k = 0; k < vertex.count; ++k) influences_[vertex.first + k].share /= kept;
  vertices_.push_back(vertex);
}

void HandSkin::bend(const std::array<double, fingers>& flexion,
                    std::vector<Eigen::Vector3f>& positions) const {
  const auto hinges = hinges_of(hand_, flexion);
  positions.resize(rest_.size());
  for (std::size_t v = 0; v < rest_.size(); ++v) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::uint32_t k = 0; k < vertices_[v].count; ++k) {
      const Influence& influence = influences_[vertices_[v].first + k];
      Eigen::Vector3f x = rest_[v];
      // Iterates from the fingertip inwards: each joint rotates everything distal to it, in the open hand's
      // frames.
      for (std::size_t joint = joints_of(influence.finger); joint-- > 0;) {
        const Hinge& hinge = hinges[first_joint(influence.finger) + joint];
        const float angle = hinge.angle * influence.turned[joint];
        if (angle != 0) x = Eigen::AngleAxisf(angle, hinge.axis) * (x - hinge.origin) + hinge.origin;
      }
      sum += influence.share * x;
    }
    positions[v] = sum;
  }
}

SkinnedHand skin_hand(const HandSkin& skin, const std::array<double, fingers>& flexion) {
  SkinnedHand out;
  skin.bend(flexion, out.positions);
  smooth_normals(out.positions, skin.triangles(), out.normals);
  return out;
}

}  // namespace prosector
