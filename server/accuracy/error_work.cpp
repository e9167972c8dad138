#include "server/accuracy/error_work.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/laws/mean_dilatation.h"
#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector::estimation {
namespace {

/// Calibration of the error indicator: true squared error divided by η², fitted with `prosector-bench
/// estimate`.
struct Surplus {
  double even;          // factor for evenly distributed loads
  double concentrated;  // number of loaded vertices at which the factor doubles
};
constexpr Surplus linear_surplus = {1, 4.5}, quadratic_surplus = {0.6, 10};
constexpr double doubt = 0.2;  // relative uncertainty of a part, where two parts cancel
constexpr double negligible_strain = 1e-5;
constexpr double max_reported_error = 1e3;  // largest error reported, also for one that is not a number

double finite(double error) {
  return std::isfinite(error) ? std::clamp(error, -max_reported_error, max_reported_error)
                              : max_reported_error;
}

}  // namespace

void ErrorWork::clear() {
  done = 0;
  std::fill(residual.begin(), residual.end(), Vec3::Zero());
  std::fill(reaction.begin(), reaction.end(), Vec3::Zero());
  std::fill(disc.begin(), disc.end(), 0);
  std::fill(model.begin(), model.end(), 0);
  mean_F.setZero();
  all = press = {};
  slip = 0;
}

void ErrorWork::piece(std::size_t k) {
  if (k < element_count()) return add_element(k);
  k -= element_count();
  if (k < faces.size()) return add_face(k);
  k -= faces.size();
  if (k < functions.size()) return add_function(k);
  finish();
}

void ErrorWork::linear_state(std::size_t e, const VecX& x, ElementState& out) const {
  const MaterialLaws& law = laws[kind[e]];
  const Mat3 F = elements.edges(e, x.data()) * elements.gradients(e).transpose();
  Mat3 P;
  law.own->stress({&F, 1}, {}, {&P, 1});
  out.R = polar(F).R;
  out.P.fill(P);
  out.S = out.R.transpose() * F;
  out.Q = out.R.transpose() * P;
  out.work = P.cwiseProduct(F - out.R).sum();
  if (law.tissue) out.law = law_difference(*law.tissue, 0, {{&F, 1}, {&out.R, 1}, {&P, 1}});
}

void ErrorWork::quadratic_state(std::size_t e, const VecX& x, ElementState& out) const {
  const MaterialLaws& law = laws[kind[e]];
  std::array<double, 48> moved;
  tet10->move(e, x.data(), moved.data());
  std::array<Mat3, 4> F, P, R;
  std::array<double, 4> dilatation, pressure;
  for (std::size_t q = 0; q < 4; ++q) {
    const Eigen::Map<const Columns> D(moved.data() + 12 * q);
    F[q] = (D.rightCols<3>().colwise() - D.col(0)) * elements.gradients(e).transpose();
  }
  law.own->dilatation(F, dilatation);
  pressure.fill(law.mean * (dilatation[0] + dilatation[1] + dilatation[2] + dilatation[3]) / 4);
  law.own->stress(F, pressure, P);
  out.R = polar((F[0] + F[1] + F[2] + F[3]) / 4).R;
  for (std::size_t q = 0; q < 4; ++q) {
    R[q] = polar(F[q]).R;
    out.work += P[q].cwiseProduct(F[q] - R[q]).sum() / 4;
    out.S += R[q].transpose() * F[q] / 4;
    out.Q += R[q].transpose() * P[q] / 4;
  }
  if (law.tissue) out.law = law_difference(*law.tissue, law.mean, {F, R, P});
  for (int c = 0; c < 4; ++c) {
    out.P[static_cast<std::size_t>(c)].setZero();
    for (int q = 0; q < 4; ++q)
      out.P[static_cast<std::size_t>(c)] += corners_of(c, q) * P[static_cast<std::size_t>(q)];
  }
}

void ErrorWork::add_element(std::size_t e) {
  ElementState now;
  quadratic ? quadratic_state(e, moment.x, now) : linear_state(e, moment.x, now);
  const double V = elements.volume(e);
  const Corners& nodes = elements.nodes(e);
  const Columns b = slopes(e);
  std::array<Vec3, 4> load;  // N/m³
  Vec3 all_load = Vec3::Zero();
  for (std::size_t c = 0; c < 4; ++c) {
    load[c] = density * moment.acceleration.segment<3>(at(nodes[c]));
    all_load += load[c];
  }
  all.weight += space[e] * all_load.norm() / 4;
  const Mat3 mean_P = (now.P[0] + now.P[1] + now.P[2] + now.P[3]) / 4;
  for (std::size_t c = 0; c < 4; ++c)
    reaction[nodes[c]] += V * mean_P * b.col(static_cast<int>(c)) - space[e] / 20 * (load[c] + all_load);
  for (std::size_t k = 0; k < table.of_tet.size(); ++k) {
    const Bubble& bubble = table.of_tet[k];
    Vec3 r = Vec3::Zero();
    double least_tie = std::numeric_limits<double>::infinity();
    for (const std::size_t c : bubble.corners) least_tie = std::min(least_tie, tie[nodes[c]]);
    for (int c = 0; c < 4; ++c) {
      const auto corner = static_cast<std::size_t>(c);
      if (quadratic) r += V * (now.P[corner] * (b * bubble.stress.row(c).transpose()));
      Vec3 f = load[corner];
      if (least_tie > 0)
        f -= std::min(least_tie, tie[nodes[corner]]) *
             (moment.x.segment<3>(at(nodes[corner])) - mesh.positions[nodes[corner]]);
      r -= space[e] * bubble.load[c] * f;
    }
    if (!quadratic) r += V * (mean_P * (b * bubble.slope));
    residual[function[e * table.of_tet.size() + k]] += r;
  }
  S[e] = now.S;
  Q[e] = now.Q;
  R[e] = now.R;
  mean_F += V * now.R * now.S;
  law[e] = now.law;
  const double left_over =
      V * (rest.known ? work_on_top(now.law, rest.law[e], now.S - rest.S[e]) : now.law.work);
  all.law += left_over;
  for (const std::uint32_t node : nodes) model[node] += std::abs(left_over) / 4;
  const auto add_work = [&](Sums& sums, const Baseline& base) {
    if (base.known)
      sums.work += V * (now.Q - base.Q[e]).cwiseProduct(now.S - base.S[e]).sum();
    else
      sums.work += V * now.work;
  };
  add_work(all, rest);
  add_work(press, quiet.known ? quiet : rest);
  const Mat3 moved =
      now.R.transpose() * elements.edges(e, moment.slip.data()) * elements.gradients(e).transpose();
  const Mat3 strain = (moved + moved.transpose()) / 2;
  const Lame& lame = laws[kind[e]].lame;
  slip += V * (2 * lame.mu * strain.squaredNorm() + lame.lambda * strain.trace() * strain.trace());
}

/// Treats the unbalanced forces at a face's vertices as a surface traction that is linear over the face.
void ErrorWork::add_face(std::size_t f) {
  const OuterFace& face = faces[f];
  const double size = area_vector(mesh, face).norm();
  std::array<Vec3, 3> traction;
  for (std::size_t c = 0; c < 3; ++c)
    traction[c] = tie[face[c]] > 0 ? Vec3(Vec3::Zero()) : Vec3(reaction[face[c]] / area[face[c]]);
  for (std::size_t k = 0; k < table.of_face.size(); ++k) {
    Vec3& r = residual[face_function[f * table.of_face.size() + k]];
    for (int c = 0; c < 3; ++c) r -= size * table.of_face[k].load[c] * traction[static_cast<std::size_t>(c)];
  }
}

/// Returns r·K⁻¹·r of a function, J, with the residual that exceeds a baseline.
double ErrorWork::above(const Baseline& base, std::size_t k, const Vec3& r) const {
  Vec3 more = r;
  if (base.known) more -= polar(mean_F).R * base.turn.transpose() * base.residual[k];
  const Vec3 turned = R[owner[k]].transpose() * more;
  return turned.dot(compliance[k] * turned);
}

/// Adds the powers of the forces on outer vertices that exceed a baseline.
void ErrorWork::add_forces(const Baseline& base, Sums& sums) const {
  const Mat3 turn = base.known ? Mat3(polar(mean_F).R * base.turn.transpose()) : Mat3(Mat3::Zero());
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    if (area[i] == 0 || tie[i] > 0) continue;
    Vec3 force = reaction[i];
    if (base.known) force -= turn * base.reaction[i];
    sums.squares += force.squaredNorm();
    sums.fourths += force.squaredNorm() * force.squaredNorm();
  }
}

/// Returns the calibration factor of η². It is larger where a load acts on few vertices: such a load is finer
/// than the mesh, which the residual does not show.
double ErrorWork::surplus_share(const Sums& sums) const {
  const Surplus& surplus = quadratic ? quadratic_surplus : linear_surplus;
  if (!(sums.fourths > 0)) return surplus.even;
  // The effective number of loaded vertices. Squared forces make the solver's small residuals on many
  // vertices negligible.
  const double vertices = sums.squares * sums.squares / sums.fourths,
               force = std::sqrt(sums.squares * vertices);
  return surplus.even * (1 + force / (force + sums.weight) * surplus.concentrated / vertices);
}

void ErrorWork::add_function(std::size_t k) {
  const double found = above(rest, k, residual[k]);
  all.surplus += found;
  press.surplus += quiet.known ? above(quiet, k, residual[k]) : found;
  const auto& corners = functions[k];
  const bool edge = corners[1] == corners[2];
  for (std::size_t c = 0; c < (edge ? 2 : 3); ++c) disc[corners[c]] += found / (edge ? 2 : 3);
}

void ErrorWork::finish() {
  newest.error = newest.press = newest.pressed = 0;
  newest.parts = {};
  std::fill(newest.local.begin(), newest.local.end(), 0);
  const double negligible = negligible_strain * negligible_strain * all_volume * laws.front().lame.mu;
  if (std::abs(all.work) < negligible) return;  // no load
  if (all.work < 0) {                           // the stress does work on the loads
    newest.error = newest.press = max_reported_error;
    return;
  }
  add_forces(rest, all);
  add_forces(quiet.known ? quiet : rest, press);
  if (!quiet.known) press.weight = all.weight;  // else the volume forces are in the baseline
  const double d = finite(surplus_share(all) * all.surplus / all.work);
  const double law = finite(all.law / all.work);
  // Where tissue is stiffer, the first-order difference is limited: a compliance can't be negative.
  const double m = law < 0 ? law / (1 - law) : law;
  newest.parts.discretisation = finite(d / (1 + d + m));
  newest.parts.model = finite(m / (1 + d + m));
  newest.parts.solver = finite(moment.solver);
  newest.parts.time = finite(std::sqrt(slip / all.work));
  const auto together = [](double a, double b) {
    return std::max(std::abs(a + b), doubt * std::max(std::abs(a), std::abs(b)));
  };
  newest.error = finite(together(newest.parts.discretisation, newest.parts.model) + newest.parts.solver +
                        newest.parts.time);
  // The contact's own compliance has a share of the dent that the elements lack.
  const double pressed_d = surplus_share(press) * press.surplus, pressed_m = m * press.work - moment.give;
  newest.press = finite(together(pressed_d, pressed_m) / (press.work + moment.give) + newest.parts.solver);
  newest.pressed = press.work / all.work;
  const double weight_d = std::abs(d), weight_m = std::abs(m), weight = weight_d + weight_m;
  double all_model = 0, all_disc = 0;
  for (std::size_t i = 0; i < volume.size(); ++i) {
    all_model += model[i];
    all_disc += disc[i];
  }
  for (std::size_t i = 0; i < volume.size(); ++i) {
    double part = 0;
    if (weight > 0 && volume[i] > 0)
      part = ((all_disc > 0 ? weight_d * disc[i] / all_disc : 0) +
              (all_model > 0 ? weight_m * model[i] / all_model : 0)) /
             weight * all_volume / volume[i];
    newest.local[i] = newest.error * part;
  }
}

void ErrorWork::keep(Baseline& base) const {
  base.S = S;
  base.Q = Q;
  base.residual = residual;
  base.reaction = reaction;
  base.turn = polar(mean_F).R;
  base.law = law;
  base.known = true;
}

}  // namespace prosector::estimation
