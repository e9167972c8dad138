#pragma once
// The reference of self-collision: where a soft surface comes near itself, by its triangles.

#include <cstdint>
#include <vector>

#include "server/physics/mechanics/collision/surface/triangle_surface.h"

namespace prosector {

struct SelfContact {
  std::uint32_t triangle_a = 0, triangle_b = 0;  // a < b, without a common vertex
  Vec3 weights_a = Vec3::Zero(), weights_b = Vec3::Zero();
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();  // m
  double distance = 0;                            // m; 0: they cross
};

/// Candidates: pairs of triangles nearer than `margin` (m), ascending. Pairs that were that near in `rest`
/// already (positions of the shape at rest; empty: none were) are neighbours, not contacts.
std::vector<SelfContact> self_contacts(const collision::TriangleSurface& surface, double margin,
                                       std::span<const Vec3> rest = {});

}  // namespace prosector
