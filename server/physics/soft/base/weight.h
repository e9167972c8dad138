#pragma once
// What gravity does to the nodes of a soft body.

#include "common/math.h"

namespace prosector {

/// The acceleration that gravity is to the nodes' masses. Of quadratic elements shape functions give an edge
/// more of an element's weight than its node has of the mass, and a vertex less than none of it.
struct Weight {
  /// Makes one that nodes bear by their masses. `gravity`: m/s²; zero: none acts.
  Weight(const Vec3& gravity = Vec3::Zero()) : acceleration(gravity) {}
  /// Makes one that nodes bear by shape functions. `shares`: n, of a node's weight by its mass; must outlive
  /// this.
  Weight(const Vec3& gravity, const VecX& shares) : acceleration(gravity), by_shape(&shares) {}

  /// Returns what it is to a node, m/s².
  Vec3 at(Eigen::Index node) const {
    return by_shape ? Vec3((*by_shape)[node] * acceleration) : acceleration;
  }
  /// Adds `factor` times what it is to each node to 3n values.
  void add(double factor, VecX& to) const {
    auto nodes = to.reshaped(3, to.size() / 3);
    if (by_shape)
      nodes += factor * acceleration * by_shape->transpose();
    else
      nodes.colwise() += factor * acceleration;
  }

  Vec3 acceleration;               // m/s², of the body as a whole
  const VecX* by_shape = nullptr;  // null: nodes bear it by their masses
};

}  // namespace prosector
