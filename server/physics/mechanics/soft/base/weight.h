#pragma once
// Gravity on the nodes of a soft body.

#include "common/math.h"

namespace prosector::soft {

/// Gravitational acceleration of a soft body's nodes, either equal for all or distributed by shape functions.
/// In quadratic elements, shape functions give an edge node more of the element's weight than its share of
/// the mass, and a vertex a negative weight.
struct Weight {
  /// Creates a weight that accelerates all nodes equally by `gravity`, m/s². A zero vector means no gravity.
  Weight(const Vec3& gravity = Vec3::Zero()) : acceleration(gravity) {}
  /// Creates a weight that accelerates node i by shares[i] times `gravity` (m/s²). `shares`: ratio of a
  /// node's weight by shape functions to its weight by mass, for n nodes; must outlive this object.
  Weight(const Vec3& gravity, const VecX& shares) : acceleration(gravity), by_shape(&shares) {}

  /// Returns the gravitational acceleration of the node with index `node`, m/s².
  Vec3 at(Eigen::Index node) const {
    return by_shape ? Vec3((*by_shape)[node] * acceleration) : acceleration;
  }
  /// Adds `factor` times the gravitational acceleration of each node to the vector `to`, which has 3 values
  /// per node.
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

}  // namespace prosector::soft
