#pragma once
// What an impulse on a rigid body does to those that ties join it to: a light tool has the hand behind it.

#include <Eigen/Cholesky>
#include <vector>

#include "server/physics/island.h"

namespace prosector {

/// Allocates only for more bodies than it has had.
class HeldTogether {
 public:
  /// Finds the response of the bodies that ties between rigid ones join, where the island's twists take them.
  /// A pull counts as inertia k·h², and so does a tie.
  void find(const Island& island, double h);

  /// Returns the joined ones among the island's rigid members, ascending.
  const std::vector<std::size_t>& members() const { return members_; }
  /// Returns the map from an impulse (N·s, N·m·s) on one of them to the velocities (m/s, rad/s) that another
  /// gets, both by place.
  auto response(std::size_t to, std::size_t from) const {
    return response_.block<6, 6>(6 * static_cast<Eigen::Index>(to), 6 * static_cast<Eigen::Index>(from));
  }

 private:
  void find_members(const Island& island);

  std::vector<std::size_t> members_, place_;  // which; by member, where among them
  Eigen::MatrixXd inertia_, response_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace prosector
