#pragma once
// Skinned hand mesh: one smooth closed surface, deformed by five flexions at the 14 joints of common/hand.h.

#include <vector>

#include "common/hand.h"

namespace prosector {

/// Skin mesh and skinning weights of a right or left hand, shared by all hands of that side. Positions are in
/// the wrist frame, in metres.
class HandSkin {
 public:
  /// Builds the skin mesh of the right (1) or left (0) hand. Left and right are exact mirror images. Takes
  /// several tenths of a second.
  explicit HandSkin(std::size_t hand);
  /// Returns the skin of the hand of the other side, mirrored from this one.
  HandSkin mirrored() const;

  /// Returns the vertex positions (m, wrist frame) of the open hand.
  const std::vector<Eigen::Vector3f>& rest() const { return rest_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  /// Writes the vertex positions (m, wrist frame) of the hand with the given finger flexions to `positions`.
  void bend(const std::array<double, fingers>& flexion, std::vector<Eigen::Vector3f>& positions) const;

 private:
  /// Influence of one finger's joints on a skin vertex. Each joint rotates the vertex by a share of its
  /// angle, instead of blending rotated positions. This keeps the distance to the joint axis, so no joint
  /// collapses at 90° (compare Kavan and Žára 2005).
  struct Influence {
    std::uint8_t finger;
    float share;                  // of this finger's influence on the vertex; shares sum to 1
    std::array<float, 3> turned;  // share of each joint's angle applied, proximal first
  };
  struct Vertex {
    std::uint32_t first, count;  // into influences_
  };

  void weigh(const Vec3& rest_of_right_hand);

  std::size_t hand_;
  std::vector<Eigen::Vector3f> rest_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Vertex> vertices_;
  std::vector<Influence> influences_;
};

/// Builds the skin meshes of the left and the right hand. The left one is mirrored from the right one, which
/// halves the time.
std::array<HandSkin, 2> make_hand_skins();

/// Vertex positions (m, wrist frame) and normals of the skin of one bent hand.
struct SkinnedHand {
  std::vector<Eigen::Vector3f> positions, normals;
};
SkinnedHand skin_hand(const HandSkin& skin, const std::array<double, fingers>& flexion);

}  // namespace prosector
