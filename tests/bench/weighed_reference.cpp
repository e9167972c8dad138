#include "tests/bench/weighed_reference.h"

#include <cmath>
#include <stdexcept>

#include "server/accuracy/displacement.h"
#include "tests/soft/kuhn.h"

namespace prosector {

std::span<const WeighedReference> weighed_references() {
  static const WeighedReference references[] = {
      {"cube",
       weighed_cube,
       0.49,
       -9.81,
       {2, 2, 2},
       {Vec3(0, -7.962e-3, 0), Vec3(0, -6.963e-3, -0.036e-3), Vec3(-0.107e-3, -6.102e-3, -0.107e-3),
        Vec3(-2.497e-3, -4.669e-3, 0)},
       0.005},
      {"slab",
       weighed_slab,
       0.49,
       -9.81,
       {4, 2, 4},
       {Vec3(0, -1.400e-3, 0), Vec3(0, -1.951e-3, -1.241e-3), Vec3(-1.326e-3, -2.568e-3, -1.326e-3),
        Vec3(-2.034e-3, -1.355e-3, 0)},
       0.01},
      {"hang",
       weighed_cube,
       0.45,
       9.81,
       {2, 2, 2},
       {Vec3(0, 9.672e-3, 0), Vec3(0, 8.710e-3, 0.085e-3), Vec3(0.167e-3, 7.861e-3, 0.167e-3),
        Vec3(2.349e-3, 6.173e-3, 0)},
       0.002}};
  return references;
}

std::array<Vec3, weighed_places> places_of(const WeighedReference& which) {
  const Vec3& size = which.body.size;
  return {size.cwiseProduct(Vec3(0.5, 1, 0.5)), size.cwiseProduct(Vec3(0.5, 1, 0)),
          size.cwiseProduct(Vec3(0, 1, 0)), size.cwiseProduct(Vec3(0, 0.5, 0.5))};
}

double error_of(const WeighedReference& which, const std::array<Vec3, weighed_places>& moved) {
  double error = 0, sum = 0;
  for (std::size_t k = 0; k < weighed_places; ++k) {
    error += (moved[k] - which.moved[k]).squaredNorm();
    sum += which.moved[k].squaredNorm();
  }
  return std::sqrt(error / sum);
}

std::array<Vec3, weighed_places> moved_at_rest(const WeighedReference& which, std::uint32_t times) {
  Cells cells = which.coarse;
  for (std::uint32_t& n : cells) n *= times;
  const Weighed found(weighed_desc(which.body, "tet10", which.poisson_ratio),
                      kuhn_anatomy(cells, which.body.size), which.gravity);
  if (!found.answer.usable()) throw std::logic_error("the reference solution did not converge");
  const Vec3 middle = which.body.size / 2;
  std::array<Vec3, weighed_places> moved;
  moved.fill(Vec3::Zero());
  for (const Vec3& mirror : {Vec3(1, 1, 1), Vec3(-1, 1, 1), Vec3(1, 1, -1), Vec3(-1, 1, -1)}) {
    std::array<Vec3, weighed_places> places = places_of(which);
    for (Vec3& place : places) place = middle + mirror.cwiseProduct(place - middle);
    const Probes probes(found.body, places);
    for (std::size_t k = 0; k < weighed_places; ++k)
      moved[k] += mirror.cwiseProduct(probes.displacement(k, found.answer.x).value()) / 4;
  }
  return moved;
}

std::array<Vec3, weighed_places> extrapolated(
    const std::array<std::array<Vec3, weighed_places>, 3>& by_mesh) {
  constexpr double slowest = 1.5, fastest = 10;  // accepted ratio of successive differences
  std::array<Vec3, weighed_places> out = by_mesh[2];
  for (std::size_t k = 0; k < weighed_places; ++k)
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double step = by_mesh[1][k][axis] - by_mesh[0][k][axis],
                   next = by_mesh[2][k][axis] - by_mesh[1][k][axis];
      const double falls = next == 0 ? 0 : step / next;
      const bool evenly = falls > slowest && falls < fastest;
      out[k][axis] += evenly ? next / (falls - 1) : next / 3;
    }
  return out;
}

}  // namespace prosector
