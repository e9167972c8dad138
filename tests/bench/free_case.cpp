// A thrown, spinning block. Only gravity acts on it, so its momentum, its angular momentum about the centre
// of mass and its energy are known at any time.

#include <cmath>

#include "tests/bench/specimen_measures.h"
#include "tests/bench/trade_case.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double flight_s = 1;
const Vec3 gravity(0, -9.81, 0), thrown(1, 3, 0), spin(0.5, 6.5, 0.3);  // m/s², m/s, rad/s
const Vec3 block(0.2, 0.1, 0.1);

/// Returns the angular momentum about the centre of mass, kg·m²/s.
Vec3 spin_momentum(const Specimen& specimen) {
  return angular_momentum(specimen) - mass_center(specimen).cross(momentum(specimen));
}

double energy(Specimen& specimen) {
  const double mass = specimen.node_mass().sum();
  return kinetic_energy(specimen) + specimen.elastic_energy() - mass * gravity.dot(mass_center(specimen));
}

ReportRow measure(Specimen& specimen, const TestPiece& piece, const std::string&, Runner& runner) {
  const VecX rest = specimen.rest();
  VecX v(rest.size());
  for (Eigen::Index k = 0; k < rest.size(); k += 3)
    v.segment<3>(k) = thrown + spin.cross(rest.segment<3>(k) - block / 2);
  specimen.set_motion(rest, v);
  const double mass = specimen.node_mass().sum(), start = energy(specimen), scale = kinetic_energy(specimen);
  const Vec3 p = momentum(specimen), l = spin_momentum(specimen), c = mass_center(specimen);
  const double rest_volume = volume(piece.mesh, rest);
  ReportRow row = ReportRow::object();
  if (!runner.run(flight_s, [](double) {})) return row;
  const double t = runner.figures()["simulated_s"];
  const Vec3 landed = c + thrown * t + gravity * t * t / 2;
  row["energy_drift"] = (energy(specimen) - start) / scale;
  row["momentum_drift"] = (momentum(specimen) - p - mass * gravity * t).norm() / p.norm();
  row["angular_momentum_drift"] = (spin_momentum(specimen) - l).norm() / l.norm();
  row["fall_error"] = (mass_center(specimen) - landed).norm() / (landed - c).norm();
  row["volume_loss"] = 1 - volume(piece.mesh, specimen.positions()) / rest_volume;
  return row;
}

}  // namespace

const TradeCase& free_case() {
  static const TradeCase row = {"free",
                                "A block flies and spins: angular momentum after one second",
                                "angular_momentum_drift",
                                "change of the angular momentum in 1 s",
                                {4, 8},
                                [](unsigned cells) {
                                  TestPiece piece;
                                  piece.mesh = kuhn_box({cells, cells / 2, cells / 2}, block);
                                  piece.youngs_modulus = 1e5;
                                  return piece;
                                },
                                measure,
                                gravity,
                                true};
  return row;
}

}  // namespace prosector
