#include "drivers/fitting/simulated_field.h"

#include <array>
#include <cmath>

#include "drivers/device/field_map.h"

namespace prosector {
namespace {

constexpr int polynomial_degree = 1;
constexpr double most_noise_m = 1e-3,
                 most_noise_turn = 2e-3;  // RMS at rest, per component: m; half the angle in rad
constexpr std::array<double, 9> noise_shares = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 1e3};
constexpr double least_scale = 1e-20;  // σ² if all values are equal

double cubed(double distance) {
  return distance * distance * distance;
}

Vec3 normal_vector(std::mt19937_64& random, double rms) {
  std::normal_distribution<double> normal(0, 1);
  const double x = normal(random), y = normal(random), z = normal(random);
  return rms * Vec3(x, y, z);
}

/// Returns the rotation with this vector part of its unit quaternion.
Quat turn_of(const Vec3& v) {
  const double most = std::min(1.0, v.squaredNorm());
  return Quat(std::sqrt(1 - most), v.x(), v.y(), v.z()).normalized();
}

}  // namespace

SimulatedField::SimulatedField(std::span<const FieldSample> samples, const PoseErrors& noise) {
  const auto [centre, half] = box_of(samples, [](const FieldSample& s) { return s.truth.p; });
  centre_ = centre;
  half_ = half;
  const auto n = static_cast<Eigen::Index>(samples.size());
  polynomials_.resize(n, static_cast<Eigen::Index>(field_term_count(polynomial_degree)));
  Eigen::MatrixXd values(n, 6);  // offset, m; vector part of the unit quaternion
  for (Eigen::Index i = 0; i < n; ++i) {
    const FieldSample& s = samples[static_cast<std::size_t>(i)];
    truths_.push_back(s.truth);
    nodes_.push_back(scaled(s.truth.p));
    polynomials_.row(i) = field_terms(nodes_.back(), polynomial_degree).transpose();
    values.row(i) << (s.reported.p - s.truth.p).transpose(),
        turn_from(s.truth.q, s.reported.q).vec().transpose();
  }
  Part shift{most_noise_m, 0, 0, {}}, turn{most_noise_turn, 0, 0, {}};
  for (const double share : noise_shares) {
    const SplineSolution s = solve_spline(nodes_, polynomials_, cubed, share, values);
    consider(s, values, 0, share, shift);
    consider(s, values, 3, share, turn);
  }
  solution_.resize(n + polynomials_.cols(), 6);
  solution_ << shift.solution, turn.solution;
  const double axis = 1 / std::sqrt(3.0);
  noise_ = {std::max(shift.noise, axis * noise.position), std::max(turn.noise, axis * noise.turn / 2)};
}

/// Adopts a noise level if it is more likely than the best one so far.
void SimulatedField::consider(const SplineSolution& spline, const Eigen::MatrixXd& values, Eigen::Index first,
                              double share, Part& best) const {
  const Eigen::Index n = values.rows(), free = n - polynomials_.cols();
  const double squares =
      values.middleCols(first, 3).cwiseProduct(spline.solution.topRows(n).middleCols(first, 3)).sum();
  const double scale = std::max(squares / static_cast<double>(3 * free), least_scale);
  const double noise = std::sqrt(share * scale);
  const double criterion = static_cast<double>(free) * std::log(scale) + spline.log_determinant;
  if (best.solution.size() > 0 && (noise > best.most_noise || criterion >= best.criterion)) return;
  best.criterion = criterion;
  best.noise = noise;
  best.solution = spline.solution.middleCols(first, 3);
}

Pose SimulatedField::report(const Pose& truth) const {
  const Vec3 x = scaled(truth.p);
  const auto n = static_cast<Eigen::Index>(nodes_.size());
  VecX terms(n + polynomials_.cols());
  for (Eigen::Index i = 0; i < n; ++i) terms[i] = cubed((x - nodes_[static_cast<std::size_t>(i)]).norm());
  terms.tail(polynomials_.cols()) = field_terms(x, polynomial_degree);
  const Eigen::Matrix<double, 6, 1> g = solution_.transpose() * terms;
  return {truth.p + g.head<3>(), (turn_of(g.tail<3>()) * truth.q).normalized()};
}

std::vector<FieldSample> SimulatedField::again(std::mt19937_64& random) const {
  std::vector<FieldSample> out;
  for (const Pose& truth : truths_) {
    Pose reported = report(truth);
    reported.p += normal_vector(random, noise_.position);
    reported.q = (turn_of(normal_vector(random, noise_.turn)) * reported.q).normalized();
    out.push_back({reported, truth});
  }
  return out;
}

std::vector<FieldSample> SimulatedField::anywhere(std::mt19937_64& random, std::size_t count) const {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<FieldSample> out;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    const Pose truth = {centre_ + half_.cwiseProduct(Vec3(x, y, z)), Quat::Identity()};
    out.push_back({report(truth), truth});
  }
  return out;
}

}  // namespace prosector
