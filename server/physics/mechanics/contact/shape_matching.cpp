#include "server/physics/mechanics/contact/shape_matching.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <set>

#include "common/assert.h"

namespace prosector::contact {
namespace {

constexpr std::size_t most_shares = 4;
// Directions with a smaller fraction of the covariance's largest eigenvalue count as flat.
constexpr double least_extent = 1e-3;

/// Returns up to `count` nodes that carry the surface, by farthest-point sampling.
std::vector<std::uint32_t> spread_nodes(const Anatomy& anatomy, std::size_t count) {
  std::set<std::uint32_t> carriers;
  for (const SparseMap::Row& row : anatomy.embedding.rows)
    for (std::size_t k = 0; k < row.node.size(); ++k)
      if (row.weight[k] != 0) carriers.insert(row.node[k]);
  const std::vector<std::uint32_t> from(carriers.begin(), carriers.end());
  std::vector<double> distance(from.size(), std::numeric_limits<double>::max());
  std::vector<std::uint32_t> out;
  std::size_t next = 0;
  while (out.size() < std::min(count, from.size())) {
    out.push_back(from[next]);
    const Vec3& x = anatomy.tets.positions[from[next]];
    for (std::size_t i = 0; i < from.size(); ++i)
      distance[i] = std::min(distance[i], (anatomy.tets.positions[from[i]] - x).squaredNorm());
    next = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return out;
}

Mat3 pseudo_inverse(const Mat3& covariance) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance);
  Mat3 out = Mat3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (const double value = eigen.eigenvalues()[k]; value > least_extent * eigen.eigenvalues()[2])
      out += eigen.eigenvectors().col(k) * eigen.eigenvectors().col(k).transpose() / value;
  return out;
}

}  // namespace

ShapeMatching::ShapeMatching(const Anatomy& anatomy) {
  const auto nodes = spread_nodes(anatomy, most_shares * ContactSide::most_nodes);
  // Assigns nodes round-robin, so that each share is spread over the whole body.
  shares_.resize(std::clamp<std::size_t>(nodes.size() / ContactSide::most_nodes, 1, most_shares));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Share& share = shares_[i % shares_.size()];
    if (share.nodes.size() < ContactSide::most_nodes) share.nodes.push_back(nodes[i]);
  }
}

void ShapeMatching::fit(const VecX& x) {
  for (Share& share : shares_) {
    const auto count = static_cast<double>(share.nodes.size());
    const auto at = [&](std::uint32_t node) { return Vec3(x.segment<3>(3 * Eigen::Index{node})); };
    share.centre.setZero();
    for (const std::uint32_t node : share.nodes) share.centre += at(node) / count;
    share.arms.clear();
    Mat3 covariance = Mat3::Zero();
    for (const std::uint32_t node : share.nodes) {
      const Vec3& arm = share.arms.emplace_back(at(node) - share.centre);
      covariance += arm * arm.transpose() / count;
    }
    share.inverse = pseudo_inverse(covariance);
  }
}

Vec3 ShapeMatching::spin(const VecX& v) const {
  Vec3 out = Vec3::Zero();
  for (const Share& share : shares_) {
    Mat3 gradient = Mat3::Zero();  // 1/s
    for (std::size_t i = 0; i < share.nodes.size(); ++i)
      gradient += v.segment<3>(3 * Eigen::Index{share.nodes[i]}) * share.arms[i].transpose() * share.inverse /
                  static_cast<double>(share.nodes.size());
    out += Vec3(gradient(2, 1) - gradient(1, 2), gradient(0, 2) - gradient(2, 0),
                gradient(1, 0) - gradient(0, 1)) /
           2;
  }
  return out / static_cast<double>(shares_.size());
}

Vec3 ShapeMatching::hang(const Vec3& p, const Vec3& normal, std::size_t index, ContactSide& side) const {
  PROSECTOR_ASSERT(index < shares_.size());
  const Share& share = shares_[index];
  PROSECTOR_ASSERT(share.arms.size() == share.nodes.size());
  double lowest = 0, highest = 0;
  for (const Vec3& arm : share.arms) {
    lowest = std::min(lowest, arm.dot(normal));
    highest = std::max(highest, arm.dot(normal));
  }
  Vec3 from_centre = p - share.centre;
  const double height = from_centre.dot(normal);
  from_centre += (std::clamp(height, lowest, highest) - height) * normal;
  const Vec3 tilt = share.inverse * from_centre;
  side.nodes = share.nodes.size();
  for (std::size_t i = 0; i < side.nodes; ++i) {
    side.node[i] = share.nodes[i];
    side.weight[i] = (1 + share.arms[i].dot(tilt)) / static_cast<double>(side.nodes);
  }
  return share.centre + from_centre;
}

}  // namespace prosector::contact
