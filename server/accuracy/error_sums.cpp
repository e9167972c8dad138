#include "server/accuracy/error_sums.h"

#include <algorithm>
#include <cmath>

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

/// Returns the relative error of two parts, which may cancel.
double together(double a, double b) {
  return std::max(std::abs(a + b), doubt * std::max(std::abs(a), std::abs(b)));
}

/// Returns the work of element e beyond a baseline, J.
double work_above(const Baseline& base, std::size_t e, double V, const ElementState& now) {
  return base.known ? V * (now.Q - base.Q[e]).cwiseProduct(now.S - base.S[e]).sum() : V * now.work;
}

/// Returns twice the strain energy of a displacement of the nodes (3n, m) in element e, J.
double slip_work(const EstimatedBody& body, std::size_t e, const Mat3& R, const VecX& displacement) {
  const Mat3 moved =
      R.transpose() * body.elements.edges(e, displacement.data()) * body.elements.gradients(e).transpose();
  const Mat3 strain = (moved + moved.transpose()) / 2;
  const soft::Lame& lame = body.laws[body.kind[e]].lame;
  return body.elements.volume(e) *
         (2 * lame.mu * strain.squaredNorm() + lame.lambda * strain.trace() * strain.trace());
}

/// Adds the powers of the forces on outer vertices that exceed a baseline.
void add_powers(const EstimatedBody& body, const MissingFunctions& functions, const StressState& state,
                const Baseline& base, Sums& sums) {
  const Mat3 turn =
      base.known ? Mat3(soft::polar(state.mean_F).R * base.turn.transpose()) : Mat3(Mat3::Zero());
  for (std::size_t i = 0; i < state.reaction.size(); ++i) {
    if (functions.area[i] == 0 || body.tie[i] > 0) continue;
    Vec3 force = state.reaction[i];
    if (base.known) force -= turn * base.reaction[i];
    sums.squares += force.squaredNorm();
    sums.fourths += force.squaredNorm() * force.squaredNorm();
  }
}

/// Returns the calibration factor of η². It is larger where a load acts on few vertices: such a load is finer
/// than the mesh, which the residual does not show.
double surplus_share(bool quadratic, const Sums& sums) {
  const Surplus& surplus = quadratic ? quadratic_surplus : linear_surplus;
  if (!(sums.fourths > 0)) return surplus.even;
  // The effective number of loaded vertices. Squared forces make the solver's small residuals on many
  // vertices negligible.
  const double vertices = sums.squares * sums.squares / sums.fourths,
               force = std::sqrt(sums.squares * vertices);
  return surplus.even * (1 + force / (force + sums.weight) * surplus.concentrated / vertices);
}

}  // namespace

ErrorSums::ErrorSums(std::size_t vertices) : disc(vertices, 0), model(vertices, 0) {}

void ErrorSums::clear() {
  std::fill(disc.begin(), disc.end(), 0);
  std::fill(model.begin(), model.end(), 0);
  all = press = {};
  slip = 0;
}

void ErrorSums::add_element(const EstimatedBody& body, std::size_t e, const ElementState& now,
                            const Baselines& before, const VecX& slip_of_nodes) {
  const double V = body.elements.volume(e);
  all.weight += body.space[e] * now.force.sum.norm() / 4;
  add_law_work(body, e, now, before.rest);
  all.work += work_above(before.rest, e, V, now);
  press.work += work_above(before.before_press(), e, V, now);
  slip += slip_work(body, e, now.R, slip_of_nodes);
}

void ErrorSums::add_law_work(const EstimatedBody& body, std::size_t e, const ElementState& now,
                             const Baseline& rest) {
  const double left_over = body.elements.volume(e) *
                           (rest.known ? work_on_top(now.law, rest.law[e], now.S - rest.S[e]) : now.law.work);
  all.law += left_over;
  for (const std::uint32_t node : body.elements.nodes(e)) model[node] += std::abs(left_over) / 4;
}

void ErrorSums::add_function(const FunctionIndex::Key& corners, double of_all, double of_press) {
  all.surplus += of_all;
  press.surplus += of_press;
  const bool edge = corners[1] == corners[2];
  for (std::size_t c = 0; c < (edge ? 2 : 3); ++c) disc[corners[c]] += of_all / (edge ? 2 : 3);
}

void ErrorSums::add_forces(const EstimatedBody& body, const MissingFunctions& functions,
                           const StressState& state, const Baselines& before) {
  add_powers(body, functions, state, before.rest, all);
  add_powers(body, functions, state, before.before_press(), press);
  if (!before.quiet.known) press.weight = all.weight;  // else the volume forces are in the baseline
}

void ErrorSums::estimate(const EstimatedBody& body, const BodyMoment& moment, Estimate& out) const {
  out.error = out.press = out.pressed = 0;
  out.parts = {};
  std::fill(out.local.begin(), out.local.end(), 0);
  const double negligible =
      negligible_strain * negligible_strain * body.all_volume * body.laws.front().lame.mu;
  if (std::abs(all.work) < negligible) return;  // no load
  if (all.work < 0) {                           // the stress does work on the loads
    out.error = out.press = max_reported_error;
    return;
  }
  const double d = finite(surplus_share(body.quadratic, all) * all.surplus / all.work);
  const double law = finite(all.law / all.work);
  // Where tissue is stiffer, the first-order difference is limited: a compliance can't be negative.
  const double m = law < 0 ? law / (1 - law) : law;
  out.parts.discretisation = finite(d / (1 + d + m));
  out.parts.model = finite(m / (1 + d + m));
  out.parts.solver = finite(moment.solver);
  out.parts.time = finite(std::sqrt(slip / all.work));
  out.error = finite(together(out.parts.discretisation, out.parts.model) + out.parts.solver + out.parts.time);
  // The contact's own compliance has a share of the dent that the elements lack.
  const double pressed_d = surplus_share(body.quadratic, press) * press.surplus,
               pressed_m = m * press.work - moment.give;
  out.press = finite(together(pressed_d, pressed_m) / (press.work + moment.give) + out.parts.solver);
  out.pressed = press.work / all.work;
  distribute(d, m, body, out);
}

/// Distributes the error over the vertices by their shares of the relative errors `d` and `m`.
void ErrorSums::distribute(double d, double m, const EstimatedBody& body, Estimate& out) const {
  const double weight_d = std::abs(d), weight_m = std::abs(m), weight = weight_d + weight_m;
  const std::vector<double>& volume = body.volume;
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
             weight * body.all_volume / volume[i];
    out.local[i] = out.error * part;
  }
}

}  // namespace prosector::estimation
