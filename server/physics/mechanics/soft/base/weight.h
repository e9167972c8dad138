#pragma once
// Gravity on the nodes of a soft body.

#include "common/math.h"

namespace prosector {

/// Gravitational acceleration relative to nodal masses. With quadratic elements, consistent shape functions
/// give an edge node more of an element's weight than its share of the mass. They give a vertex a negative
/// weight.
struct Weight {
  /// Creates a weight distributed by nodal masses. `gravity`: m/s²; zero: no gravity.
  Weight(const Vec3& gravity = Vec3::Zero()) : acceleration(gravity) {}
  /// Creates a weight distributed by shape functions. `shares`: n, ratio of a node's weight by shape
  /// functions to its weight by mass; must outlive this object.
  Weight(const Vec3& gravity, const VecX& shares) : acceleration(gravity), by_shape(&shares) {}

  /// Returns the acceleration of a node, m/s².
  Vec3 at(Eigen::Index node) const {
    return by_shape ? Vec3((*by_shape)[node] * acceleration) : acceleration;
  }
  /// Adds `factor` times the acceleration of each node to 3n values.
  void add(double factor, VecX& to) const {
    auto nodes = to.reshaped(3, to.size() / 3);
    if (by_shape)
      nodes += factor * acceleration * by_shape->transpose();
    else
      nodes.colwise() += factor * acceleration;
  }

  Vec3 acceleration;               // m/s², of the body as a whole
  const VecX* by_shape = nullptr;  // null: distributed by nodal masses
};

}  // namespace prosector
