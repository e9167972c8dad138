#pragma once
// A hand as others see it: one smooth closed skin that five flexions bend at the 14 joints of common/hand.h.

#include <vector>

#include "common/hand.h"

namespace prosector {

/// The skin of a right or left hand with its weights, shared by all hands of that side. Wrist frame, metres.
class HandSkin {
 public:
  /// Makes the skin; left and right are exact mirror images. Takes some tenths of a second.
  explicit HandSkin(std::size_t hand);
  /// Returns the skin of the other hand.
  HandSkin mirrored() const;

  /// Returns the open hand's vertices.
  const std::vector<Eigen::Vector3f>& rest() const { return rest_; }
  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  /// Writes where a bent hand's vertices are.
  void bend(const std::array<double, fingers>& flexion, std::vector<Eigen::Vector3f>& positions) const;

 private:
  /// How far a joint's turn is felt at a vertex. Turning by a share of the angle, rather than mixing turned
  /// positions, keeps the distance to the joint's axis: no joint collapses at 90° (compare Kavan and Žára
  /// 2005).
  struct Influence {
    std::uint8_t finger;
    float share;                  // of this finger in the vertex; shares sum to 1
    std::array<float, 3> turned;  // of each joint's angle, proximal first
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

/// Makes left and right, for the price of one.
std::array<HandSkin, 2> make_hand_skins();

/// Positions and normals of one bent hand.
struct SkinnedHand {
  std::vector<Eigen::Vector3f> positions, normals;
};
SkinnedHand skin_hand(const HandSkin& skin, const std::array<double, fingers>& flexion);

}  // namespace prosector
