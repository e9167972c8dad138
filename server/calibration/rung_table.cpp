#include "server/calibration/rung_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "server/calibration/beam_piece.h"
#include "server/calibration/bend_reference.h"

namespace prosector {
namespace {

constexpr double least_error = 1e-4;  // accuracy of the references

BodyGeometry beam_geometry(double elements) {
  const double volume = beam_size.prod();
  const double area =
      2 * (beam_size[0] * beam_size[1] + beam_size[1] * beam_size[2] + beam_size[2] * beam_size[0]);
  return {elements, volume, 4 * volume / area};
}

double bend_error(const std::string& model, double poisson_ratio, double sag, bool own_law) {
  const double right = own_law ? continuum_sag(model, poisson_ratio).value_or(tissue_sag(poisson_ratio))
                               : tissue_sag(poisson_ratio);
  return std::max(least_error, std::abs(sag / right - 1));
}

}  // namespace

double BodyGeometry::fineness() const {
  return thickness / std::cbrt(volume / elements);
}

BodyGeometry geometry_of(const TetMesh& mesh) {
  BodyGeometry out;
  out.elements = static_cast<double>(mesh.tets.size());
  std::map<std::array<std::uint32_t, 3>, double> faces;  // area of outer faces, m²
  for (const auto& tet : mesh.tets) {
    const auto x = [&](std::size_t k) { return mesh.positions[tet[k]]; };
    out.volume += std::abs((x(1) - x(0)).cross(x(2) - x(0)).dot(x(3) - x(0))) / 6;
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      const std::size_t a = (left_out + 1) % 4, b = (left_out + 2) % 4, c = (left_out + 3) % 4;
      std::array<std::uint32_t, 3> face = {tet[a], tet[b], tet[c]};
      std::sort(face.begin(), face.end());
      const auto [at, is_new] = faces.try_emplace(face, (x(b) - x(a)).cross(x(c) - x(a)).norm() / 2);
      if (!is_new) faces.erase(at);
    }
  }
  double area = 0;
  for (const auto& [face, of_face] : faces) area += of_face;
  out.thickness = 4 * out.volume / area;
  return out;
}

double table_ratio(double poisson_ratio) {
  for (const double ratio : bend_ratios)
    if (poisson_ratio <= ratio) return ratio;
  return *std::rbegin(bend_ratios);
}

double log_interpolate(const std::vector<double>& xs, const std::vector<double>& ys, double x, double low,
                       double high) {
  if (xs.size() == 1) return ys[0] * std::pow(x / xs[0], low);
  const auto above = std::upper_bound(xs.begin(), xs.end(), x);
  const std::size_t k =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - xs.begin()), 1, xs.size() - 1);
  double rate = std::log(ys[k] / ys[k - 1]) / std::log(xs[k] / xs[k - 1]);
  const bool inside = x >= xs.front() && x <= xs.back();
  if (!inside) rate = std::clamp(rate, low, high);
  const std::size_t from = x > xs.back() ? k : k - 1;
  return ys[from] * std::pow(x / xs[from], rate);
}

const RungFigures* RungTable::find(const RungTrial& trial) const {
  for (const Row& row : rows_)
    if (row.trial == trial) return &row.figures;
  return nullptr;
}

/// Returns the rung's rows, coarsest first.
std::vector<const RungTable::Row*> RungTable::rows_of(const Rung& rung, double poisson_ratio) const {
  std::vector<const Row*> out;
  for (const Row& row : rows_)
    if (row.trial.rung == rung && row.trial.poisson_ratio == poisson_ratio) out.push_back(&row);
  std::sort(out.begin(), out.end(),
            [](const Row* a, const Row* b) { return a->figures.elements < b->figures.elements; });
  return out;
}

std::pair<double, double> RungTable::measured_fineness(const Rung& rung, double poisson_ratio) const {
  const auto rows = rows_of(rung, table_ratio(poisson_ratio));
  if (rows.empty()) return {0, 0};
  return {beam_geometry(rows.front()->figures.elements).fineness(),
          beam_geometry(rows.back()->figures.elements).fineness()};
}

std::optional<Prospect> RungTable::prospect(const Rung& rung, double poisson_ratio, const BodyGeometry& body,
                                            bool own_law) const {
  const double ratio = table_ratio(poisson_ratio);
  const auto rows = rows_of(rung, ratio);
  if (rows.empty()) return std::nullopt;
  std::vector<double> fineness, errors, drifts, elements, ms;
  for (const Row* row : rows) {
    elements.push_back(row->figures.elements);
    ms.push_back(row->figures.ms);
    fineness.push_back(beam_geometry(row->figures.elements).fineness());
    const double off = bend_error(rung.model, ratio, row->figures.settled_sag, own_law);
    errors.push_back(off + row->figures.drift);
    drifts.push_back(rung.is_position_based() ? errors.back() : std::max(least_error, row->figures.drift));
  }
  // Where a finer mesh has a larger error, the errors of the coarser one cancel by chance.
  for (std::size_t k = errors.size() - 1; k-- > 0;) errors[k] = std::max(errors[k], errors[k + 1]);
  constexpr double never_better = 0, fourth_order = -4;
  const double finest = std::min(body.fineness(), fineness.back());
  return Prospect{log_interpolate(fineness, errors, finest, fourth_order, never_better),
                  log_interpolate(fineness, drifts, finest, fourth_order, never_better),
                  log_interpolate(elements, ms, body.elements, 1, 4. / 3)};
}

}  // namespace prosector
