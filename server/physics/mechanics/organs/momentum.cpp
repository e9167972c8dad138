#include "server/physics/mechanics/organs/momentum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <vector>

#include "common/assert.h"

namespace prosector::organs {
namespace {

constexpr double least_inertia = 1e-6;   // of the largest moment of inertia: below this, nodes lie on an axis
constexpr double point_inertia = 1e-12;  // of all nodes' inertia: below this, the nodes coincide
constexpr double absent = -1;            // kg: marks nodes that did not exist before

/// Total mass and motion of all nodes for which `counts(piece, index)` is true.
struct Whole {
  double mass = 0;             // kg
  Vec3 centre = Vec3::Zero();  // m
  Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();
  Mat3 inertia = Mat3::Zero();  // kg m², about the centre
};

template <class Counts>
Whole whole(std::span<const PieceMotion> pieces, const Counts& counts) {
  Whole out;
  const auto each = [&](const auto& f) {
    for (const PieceMotion& piece : pieces)
      for (std::size_t n = 0; n < piece.nodes.size(); ++n) {
        const auto i = static_cast<Eigen::Index>(n);
        if (counts(piece, n))
          f((*piece.mass)[i], piece.place->segment<3>(3 * i), piece.velocity->segment<3>(3 * i));
      }
  };
  each([&](double m, const auto& x, const auto& v) {
    out.mass += m;
    out.centre += m * x;
    out.momentum += m * v;
  });
  if (!(out.mass > 0)) return out;
  out.centre /= out.mass;
  each([&](double m, const auto& x, const auto& v) {
    const Vec3 r = x - out.centre;
    out.spin += m * r.cross(v - out.momentum / out.mass);
    out.inertia += m * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  });
  return out;
}

/// Returns the angular velocity (rad/s) for this angular momentum, about the principal axes with more inertia
/// than `least`.
Vec3 turn_for(const Vec3& spin, const Mat3& inertia, double least) {
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(inertia);
  Vec3 out = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double I = axes.eigenvalues()[k];
    if (I > least && I > least_inertia * axes.eigenvalues()[2])
      out += axes.eigenvectors().col(k).dot(spin) / I * axes.eigenvectors().col(k);
  }
  return out;
}

}  // namespace

void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now, bool spin) {
  std::vector<double> mass_before;  // by node
  for (const PieceMotion& piece : before) {
    if (piece.nodes.empty()) continue;
    PROSECTOR_ASSERT(is_ascending(piece.nodes) && piece.mass->size() >= std::ssize(piece.nodes));
    mass_before.resize(std::max<std::size_t>(mass_before.size(), piece.nodes.back() + 1), absent);
    for (std::size_t n = 0; n < piece.nodes.size(); ++n)
      mass_before[piece.nodes[n]] = (*piece.mass)[static_cast<Eigen::Index>(n)];
  }
  const auto all = [](const PieceMotion&, std::size_t) { return true; };
  const auto changed = [&](const PieceMotion& piece, std::size_t n) {
    const cutting::NodeId id = piece.nodes[n];
    return id >= mass_before.size() || mass_before[id] != (*piece.mass)[static_cast<Eigen::Index>(n)];
  };
  const Whole was = whole(before, all), is = whole(now, all), some = whole(now, changed);
  if (!(some.mass > 0)) return;
  const Vec3 lost = was.momentum - is.momentum;
  Vec3 turn = Vec3::Zero();
  if (spin)
    turn = turn_for(was.spin - is.spin - (some.centre - is.centre).cross(lost), some.inertia,
                    point_inertia * is.inertia.trace());
  for (const PieceMotion& piece : now)
    for (std::size_t n = 0; n < piece.nodes.size(); ++n) {
      const auto i = static_cast<Eigen::Index>(n);
      if (!changed(piece, n)) continue;
      const Vec3 arm = piece.place->segment<3>(3 * i) - some.centre;
      piece.velocity->segment<3>(3 * i) += lost / some.mass + turn.cross(arm);
    }
}

}  // namespace prosector::organs
