#include "common/anatomy/bcc_lattice.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"

namespace prosector {

namespace {

constexpr double short_edge = 0.86602540378443865;  // over the lattice constant

double points_along(double extent, double cell) {
  return std::ceil(extent / (cell / short_edge)) + 5;
}

/// Returns a cell slightly above the finest one that needs at most `max_points`.
double finest_cell(const Vec3& extent, double cell, double max_points) {
  while (lattice_points(extent, cell) > max_points) cell *= 1.02;
  return 1.01 * cell;
}

}  // namespace

double lattice_points(const Vec3& extent, double cell) {
  return 2 * points_along(extent[0], cell) * points_along(extent[1], cell) * points_along(extent[2], cell);
}

void require_sizes(const SolidField& field, double cell) {
  const Vec3 extent = field.box.size();
  if (!(cell > 0) || !std::isfinite(cell) || !extent.allFinite() || !(extent.minCoeff() > 0))
    throw InputError(fmt::format(
        "mesh: the cell is {} m and the shape's bounding box {} x {} x {} m; allowed: positive sizes", cell,
        extent[0], extent[1], extent[2]));
}

BccLattice::BccLattice(const SolidField& field, double cell, const Vec3& offset, double max_points) {
  const Vec3 extent = field.box.size();
  require_sizes(field, cell);
  if (lattice_points(extent, cell) > max_points)
    throw InputError(fmt::format(
        "mesh: a cell of {:.3g} mm is too fine for a shape {:.3g} x {:.3g} x {:.3g} m large: it needs {:.2g} "
        "lattice points, of at most {:.2g}; allowed: a cell of {:.3g} mm or more",
        1000 * cell, extent[0], extent[1], extent[2], lattice_points(extent, cell), max_points,
        1000 * finest_cell(extent, cell, max_points)));
  a_ = cell / short_edge;
  // A margin of one cell below (and the offset within it) and one above, so that the surface never reaches
  // the lattice's border.
  origin_ = field.box.min - a_ * (Vec3::Constant(1.6) + offset);
  for (std::size_t k = 0; k < 3; ++k)
    n_[k] = static_cast<int>(points_along(extent[static_cast<int>(k)], cell));
  grid_ = static_cast<std::size_t>(n_[0]) * static_cast<std::size_t>(n_[1]) * static_cast<std::size_t>(n_[2]);
}

BccLattice::Index BccLattice::index(std::size_t point) const {
  std::size_t p = point < grid_ ? point : point - grid_;
  const auto nx = static_cast<std::size_t>(n_[0]), ny = static_cast<std::size_t>(n_[1]);
  return {static_cast<int>(p % nx), static_cast<int>(p / nx % ny), static_cast<int>(p / nx / ny)};
}

Vec3 BccLattice::position(std::size_t point) const {
  const Index i = index(point);
  const double shift = point < grid_ ? 0 : 0.5;
  return origin_ + a_ * (Vec3(i[0], i[1], i[2]) + Vec3::Constant(shift));
}

bool BccLattice::parity(std::size_t p, std::size_t n) const {
  const Index i = index(p), j = index(n);
  // A centre is half a cell above its index: it is higher unless its index is lower.
  bool even = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const bool rises = p < grid_ ? j[k] >= i[k] : j[k] > i[k];
    if (rises) even = !even;
  }
  return even;
}

}  // namespace prosector
