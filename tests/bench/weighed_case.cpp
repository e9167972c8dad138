// The cases cube, slab and hang: tissue that stands on a bonded foot or hangs from it under its own weight.
// The static displacements of four points are measured.

#include <cmath>

#include "tests/bench/specimen_measures.h"
#include "tests/bench/trade_case.h"
#include "tests/bench/weighed_reference.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double settle_s = 1.5;
enum Which : std::size_t { cube, slab, hang };

const WeighedReference& reference(std::size_t which) {
  return weighed_references()[which];
}

template <std::size_t which>
TestPiece piece(unsigned cells) {
  const WeighedReference& right = reference(which);
  Cells each = right.coarse;
  for (std::uint32_t& n : each) n = n * cells / right.coarse[0];
  TestPiece piece;
  piece.mesh = kuhn_box(each, right.body.size);
  piece.youngs_modulus = weighed_modulus;
  piece.poisson_ratio = right.poisson_ratio;
  piece.density = weighed_density;
  piece.damping_mass = 30;
  piece.clamped_axis = 1;
  return piece;
}

template <std::size_t which>
void judge(ReportRow& row) {
  if (!row.contains("moved_m") || !row["moved_m"].is_array()) return;
  std::array<Vec3, weighed_places> moved;
  for (std::size_t k = 0; k < weighed_places; ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      moved[k][static_cast<Eigen::Index>(axis)] = row["moved_m"][k][axis].get<double>();
  row["error_material"] = error_of(reference(which), moved);
}

template <std::size_t which>
ReportRow measure(Specimen& specimen, const TestPiece& piece, const std::string&, Runner& runner) {
  const VecX rest = specimen.rest();
  const double rest_volume = volume(piece.mesh, rest);
  ReportRow row = ReportRow::object();
  if (!runner.run(settle_s, [](double) {})) return row;
  const VecX x = specimen.positions();
  for (const Vec3& place : places_of(reference(which))) {
    const Vec3 moved = (x - rest).segment<3>(3 * node_at(rest, place));
    row["moved_m"].push_back({moved[0], moved[1], moved[2]});
  }
  row["volume_loss"] = 1 - volume(piece.mesh, x) / rest_volume;
  row["speed_left_m_per_s"] = specimen.velocities().lpNorm<Eigen::Infinity>();
  return row;
}

template <std::size_t which>
TradeCase weighed(const char* title, const std::vector<unsigned>& cells) {
  return {reference(which).name,
          title,
          "error_material",
          "RMS error at four points, at rest",
          cells,
          piece<which>,
          measure<which>,
          {0, reference(which).gravity, 0},
          false,
          judge<which>};
}

}  // namespace

const TradeCase& cube_case() {
  static const TradeCase row = weighed<cube>("A cube stands under its own weight (ν = 0.49)", {2, 4, 8});
  return row;
}

const TradeCase& slab_case() {
  static const TradeCase row = weighed<slab>("A slab stands under its own weight (ν = 0.49)", {4, 8, 12});
  return row;
}

const TradeCase& hang_case() {
  static const TradeCase row = weighed<hang>("A cube hangs under its own weight (ν = 0.45)", {2, 4, 8});
  return row;
}

}  // namespace prosector
