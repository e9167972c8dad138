#include "drivers/fitting/field_fit.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>

#include "common/error.h"
#include "drivers/fitting/simulated_field.h"
#include "drivers/fitting/spline_system.h"

namespace prosector {
namespace {

constexpr std::size_t folds = 5;
constexpr std::array<double, 3> smoothings = {1e-3, 1e-2, 1e-1};
constexpr int most_tried_degree = 6;
constexpr double least_box = 0.05;  // m, each side
constexpr std::size_t evaluation_points = 4000;
constexpr unsigned judged_seed = 1;
constexpr double about_as_good = 1.2;

/// Returns the kernel −|r| of the map's spline, which is positive definite where Pᵀ w = 0.
double negative_distance(double distance) {
  return -distance;
}

/// Returns one row per sample of the corrections that the map must give: the translation, and the rotation
/// from the reported to the true orientation.
FieldTerms wanted(std::span<const FieldSample> samples) {
  FieldTerms out(static_cast<Eigen::Index>(samples.size()), 7);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Quat turn = turn_from(samples[i].reported.q, samples[i].truth.q);
    out.row(row) << (samples[i].truth.p - samples[i].reported.p).transpose(), turn.w(), turn.x(), turn.y(),
        turn.z();
  }
  return out;
}

/// Sets the map's box to the bounding box of the reported positions.
void set_box(std::span<const FieldSample> samples, FieldMap& map) {
  const auto [centre, half] = box_of(samples, [](const FieldSample& s) { return s.reported.p; });
  map.centre = centre;
  map.half = half;
}

/// Returns the samples of one fold, or all others.
std::vector<FieldSample> part(std::span<const FieldSample> samples, std::size_t fold, bool left_out) {
  std::vector<FieldSample> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    // Neighbours on a grid belong to different folds.
    if (((i * 7 + i / folds) % folds == fold) == left_out) out.push_back(samples[i]);
  return out;
}

/// Returns the cross-validation error of a form, m RMS.
double cross_validation_error(std::span<const FieldSample> samples, const FieldTrial& form) {
  double squares = 0;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    const FieldMap map = fit_field_form(part(samples, fold, false), form);
    const std::vector<FieldSample> left_out = part(samples, fold, true);
    const PoseErrors e = pose_errors(left_out, &map);
    squares += e.position * e.position * static_cast<double>(left_out.size());
  }
  return std::sqrt(squares / static_cast<double>(samples.size()));
}

std::vector<FieldTrial> forms_for(std::size_t samples) {
  std::vector<FieldTrial> out;
  const std::size_t fitted = samples - samples / folds - 1;
  for (int degree = 0; degree <= most_tried_degree; ++degree)
    if (2 * field_term_count(degree) <= fitted) out.push_back(polynomial_form(degree));
  for (const double smoothing : smoothings) out.push_back(spline_form(smoothing));
  return out;
}

/// Returns the form with the least expected error. Among forms about as good, returns the one with the least
/// cross-validation error.
FieldTrial choose(std::span<const FieldTrial> trials) {
  double least = trials.front().expected.position;
  for (const FieldTrial& t : trials) least = std::min(least, t.expected.position);
  const FieldTrial* best = nullptr;
  for (const FieldTrial& t : trials)
    if (t.expected.position <= about_as_good * least && (best == nullptr || t.left_out < best->left_out))
      best = &t;
  return *best;
}

}  // namespace

FieldTrial polynomial_form(int degree) {
  FieldTrial out;
  out.degree = degree;
  return out;
}

FieldTrial spline_form(double smoothing) {
  FieldTrial out;
  out.spline = true;
  out.smoothing = smoothing;
  return out;
}

std::string FieldTrial::name() const {
  return spline ? fmt::format("spline, smoothing {}", smoothing)
                : fmt::format("polynomial of degree {}", degree);
}

FieldMap fit_field_form(std::span<const FieldSample> samples, const FieldTrial& form) {
  FieldMap map;
  map.degree = form.degree;
  set_box(samples, map);
  const FieldTerms right = wanted(samples);
  const auto n = static_cast<Eigen::Index>(samples.size());
  const auto terms = static_cast<Eigen::Index>(field_term_count(form.degree));
  Eigen::MatrixXd polynomials(n, terms);
  std::vector<Vec3> places;
  for (Eigen::Index i = 0; i < n; ++i) {
    places.push_back(map.scaled(samples[static_cast<std::size_t>(i)].reported.p));
    polynomials.row(i) = field_terms(places.back(), form.degree).transpose();
  }
  if (!form.spline) {
    map.polynomial = polynomials.colPivHouseholderQr().solve(right);
    map.weights.resize(0, 7);
    return map;
  }
  const Eigen::MatrixXd solution =
      solve_spline(places, polynomials, negative_distance, form.smoothing, right).solution;
  map.nodes = std::move(places);
  map.weights = -solution.topRows(n);  // the map adds w |r|, so the sign is inverted
  map.polynomial = solution.bottomRows(terms);
  return map;
}

FieldFit fit_field(std::span<const FieldSample> samples, const PoseErrors& noise) {
  if (samples.size() < min_field_samples)
    throw InputError(
        fmt::format("{} points were measured: at least {} are needed (a grid of 3 per axis), 343 are better",
                    samples.size(), min_field_samples));
  FieldFit fit;
  set_box(samples, fit.map);
  if (fit.map.half.minCoeff() < least_box / 2)
    throw InputError(fmt::format(
        "the measured points fill a box of {:.0f} × {:.0f} × {:.0f} mm: each side must be at least {:.0f} mm",
        2e3 * fit.map.half.x(), 2e3 * fit.map.half.y(), 2e3 * fit.map.half.z(), 1e3 * least_box));
  const PoseErrors raw = pose_errors(samples, nullptr);
  fit.before = raw.position;
  fit.turn_before = raw.turn;
  const SimulatedField like(samples, noise);
  std::mt19937_64 random(judged_seed);
  const std::vector<FieldSample> again = like.again(random),
                                 judged = like.anywhere(random, evaluation_points);
  for (FieldTrial form : forms_for(samples.size())) {
    const FieldMap map = fit_field_form(again, form);
    form.expected = pose_errors(judged, &map);
    form.left_out = cross_validation_error(samples, form);
    fit.trials.push_back(form);
  }
  fit.chosen = choose(fit.trials);
  fit.map = fit_field_form(samples, fit.chosen);
  fit.map.before = fit.before;
  fit.map.after = fit.after = fit.chosen.expected.position;
  fit.turn_after = fit.chosen.expected.turn;
  return fit;
}

PoseErrors pose_errors(std::span<const FieldSample> samples, const FieldMap* map) {
  PoseErrors out;
  for (const FieldSample& s : samples) {
    const Pose x = map == nullptr ? s.reported : map->apply(s.reported);
    const double turn = x.q.angularDistance(s.truth.q);
    out.position += (x.p - s.truth.p).squaredNorm() / static_cast<double>(samples.size());
    out.turn += turn * turn / static_cast<double>(samples.size());
  }
  return {std::sqrt(out.position), std::sqrt(out.turn)};
}

}  // namespace prosector
