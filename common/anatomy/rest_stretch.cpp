#include "common/anatomy/rest_stretch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr double least_quality = 1e-9;  // 6V over an edge's cube: flatter tetrahedra are ignored

Mat3 edges_of(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet) {
  Mat3 out;
  for (int a = 0; a < 3; ++a)
    out.col(a) = mesh.positions[tet[static_cast<std::size_t>(a) + 1]] - mesh.positions[tet[0]];
  return out;
}

/// Calls f(cell index) for the cells of a grid from `first` to `last`.
template <class F>
void for_cells(const Eigen::Vector3i& first, const Eigen::Vector3i& last, const Eigen::Vector3i& size,
               const F& f) {
  for (int z = first.z(); z <= last.z(); ++z)
    for (int y = first.y(); y <= last.y(); ++y)
      for (int x = first.x(); x <= last.x(); ++x)
        f(static_cast<std::size_t>((z * size.y() + y) * size.x() + x));
}

}  // namespace

RestStretch::RestStretch(const TetMesh& mesh, std::vector<Mat3> stretch) : stretch_(std::move(stretch)) {
  PROSECTOR_ASSERT(stretch_.size() == mesh.tets.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    const Mat3 edges = edges_of(mesh, mesh.tets[t]);
    const double length = edges.colwise().norm().maxCoeff();
    if (std::abs(edges.determinant()) > least_quality * length * length * length)
      places_.push_back({t, mesh.positions[mesh.tets[t][0]], edges.inverse()});
  }
  list(mesh);
}

/// Lists the tetrahedra by the cells of a grid with about as many cells as tetrahedra.
void RestStretch::list(const TetMesh& mesh) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const auto& tet : mesh.tets)
    for (const std::uint32_t corner : tet) {
      low = low.cwiseMin(mesh.positions[corner]);
      high = high.cwiseMax(mesh.positions[corner]);
    }
  if (places_.empty()) return;
  origin_ = low;
  cell_ = std::max(std::cbrt((high - low).prod() / static_cast<double>(places_.size())),
                   (high - low).maxCoeff() / 256);
  size_ = ((high - low) / cell_).array().floor().cast<int>() + 1;
  const auto cell_at = [&](const Vec3& p) -> Eigen::Vector3i {
    const Eigen::Vector3i at = ((p - origin_) / cell_).array().floor().cast<int>();
    return at.cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Ones());
  };
  const auto for_places = [&](const auto& f) {
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      Vec3 from = Vec3::Constant(1e300), to = -from;
      for (const std::uint32_t corner : mesh.tets[places_[i].tet]) {
        from = from.cwiseMin(mesh.positions[corner]);
        to = to.cwiseMax(mesh.positions[corner]);
      }
      for_cells(cell_at(from), cell_at(to), size_, [&](std::size_t cell) { f(cell, i); });
    }
  };
  begin_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
  for_places([&](std::size_t cell, std::uint32_t) { ++begin_[cell + 1]; });
  for (std::size_t c = 0; c + 1 < begin_.size(); ++c) begin_[c + 1] += begin_[c];
  listed_.resize(begin_.back());
  std::vector<std::uint32_t> next = begin_;
  for_places([&](std::size_t cell, std::uint32_t i) { listed_[next[cell]++] = i; });
}

std::size_t RestStretch::cell_of(const Vec3& p) const {
  const Eigen::Vector3i at = ((p - origin_) / cell_).array().floor().cast<int>();
  const Eigen::Vector3i in = at.cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Ones());
  return static_cast<std::size_t>((in.z() * size_.y() + in.y()) * size_.x() + in.x());
}

double RestStretch::Place::least_coordinate(const Vec3& p) const {
  const Vec3 L = inverse * (p - origin);
  return std::min(L.minCoeff(), 1 - L.sum());
}

const Mat3& RestStretch::at(const Vec3& p) const {
  static const Mat3 none = Mat3::Identity();
  const Place* best = nullptr;
  double most = -1e300;
  const auto consider = [&](const Place& place) {
    const double least = place.least_coordinate(p);
    if (least > most) {
      most = least;
      best = &place;
    }
  };
  if (!places_.empty()) {
    const std::size_t cell = cell_of(p);
    for (std::uint32_t k = begin_[cell]; k < begin_[cell + 1]; ++k) consider(places_[listed_[k]]);
  }
  if (best == nullptr) std::for_each(places_.begin(), places_.end(), consider);
  return best == nullptr ? none : stretch_[best->tet];
}

Vec3 middle_of(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t corner : tet) sum += mesh.positions[corner];
  return sum / 4;
}

}  // namespace prosector
