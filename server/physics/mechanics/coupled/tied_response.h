#pragma once
// Response to impulses of rigid bodies that are joined by ties: a light tool moves with the hand that holds
// it.

#include <Eigen/Cholesky>
#include <vector>

#include "common/assert.h"
#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Velocity response of the rigid bodies that ties join. Allocates only when there are more bodies than
/// before.
class TiedResponse {
 public:
  /// Computes the response of the bodies that are joined by ties between rigid bodies, at the island's
  /// current twists. Pulls and ties count as additional inertia k·h².
  void find(const Island& island, double h);

  /// Returns the joined bodies as indices of the island's rigid members, ascending.
  const std::vector<std::size_t>& members() const { return members_; }
  /// Returns the 6×6 map from an impulse (N·s, N·m·s) on body `from` to the velocity change (m/s, rad/s) of
  /// body `to`. Both are indices into members().
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

}  // namespace prosector
