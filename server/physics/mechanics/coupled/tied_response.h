#pragma once
// Response to impulses of rigid bodies that are joined by ties: a light tool moves with the hand that holds
// it.

#include <Eigen/Cholesky>
#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Velocity response to impulses of the rigid bodies that are joined by ties, such as a tool and the hand
/// that holds it. Allocates memory only when there are more bodies than before.
class TiedResponse {
 public:
  /// Computes the response to impulses of all rigid bodies of the island that are tied to other rigid bodies.
  /// Pulls and ties count as additional inertia k·h² (k: stiffness), with the ties' stiffnesses at the
  /// island's current twists.
  void find(const Island& island, double h);

  /// Returns the rigid bodies that are joined by ties, as ascending indices of the island's rigid bodies.
  const std::vector<std::size_t>& members() const { return members_; }
  /// Returns the 6×6 matrix from an impulse (N·s, N·m·s) on the rigid body `from` to the velocity change
  /// (m/s, rad/s) of the body `to`. `to` and `from` are indices into members(), the bodies joined by ties.
  auto response(std::size_t to, std::size_t from) const {
    PROSECTOR_ASSERT(to < members_.size() && from < members_.size());
    return response_.block<6, 6>(6 * static_cast<Eigen::Index>(to), 6 * static_cast<Eigen::Index>(from));
  }

 private:
  void find_members(const Island& island);

  // Indices of rigid members; index into members_, by rigid member.
  std::vector<std::size_t> members_, place_;
  Eigen::MatrixXd inertia_, response_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

}  // namespace prosector::coupled
