#include "server/physics/contact/element_surface.h"

#include <set>

namespace prosector {
namespace {

SparseMap rows_of(const Anatomy& anatomy) {
  if (anatomy.thickness == 0) return anatomy.embedding;
  SparseMap out;
  for (std::uint32_t node = 0; node < anatomy.tets.positions.size(); ++node)
    out.rows.push_back({{node, node, node, node}, {1, 0, 0, 0}});
  return out;
}

std::vector<SurfaceTree::Corners> elements_of(const Anatomy& anatomy) {
  if (anatomy.thickness == 0) return anatomy.surface.triangles;
  std::vector<SurfaceTree::Corners> out;
  for (const auto& [a, b] : anatomy.segments) out.push_back({a, b, b});
  for (const auto& [a, b, c, d] : anatomy.quads) {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
  }
  return out;
}

}  // namespace

ElementSurface::ElementSurface(const Anatomy& anatomy)
    : solid_(anatomy.thickness == 0),
      rows_(rows_of(anatomy)),
      elements_(elements_of(anatomy)),
      rest_(solid_ ? anatomy.surface.positions : anatomy.tets.positions),
      positions_(rest_),
      tree_(elements_, rest_) {
  find_neighbours();
}

void ElementSurface::find_neighbours() {
  std::vector<std::vector<std::uint32_t>> with_corner(rest_.size());
  for (std::uint32_t e = 0; e < elements_.size(); ++e)
    for (const std::uint32_t corner : elements_[e]) with_corner[corner].push_back(e);
  around_begin_.push_back(0);
  for (const SurfaceTree::Corners& corners : elements_) {
    std::set<std::uint32_t> near;
    for (const std::uint32_t corner : corners)
      near.insert(with_corner[corner].begin(), with_corner[corner].end());
    around_.insert(around_.end(), near.begin(), near.end());
    around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));
  }
}

void ElementSurface::move(const VecX& x) {
  for (std::size_t i = 0; i < rows_.rows.size(); ++i) positions_[i] = rows_.apply(i, x.data());
  tree_.refit(elements_, positions_);
}

void ElementSurface::add(std::uint32_t element, const Vec3& weights, ContactSide& side) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (const double w = weights[static_cast<Eigen::Index>(k)]; w != 0)
      side.add(rows_.rows[elements_[element][k]], w);
}

}  // namespace prosector
