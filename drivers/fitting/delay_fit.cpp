#include "drivers/fitting/delay_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "common/error.h"
#include "common/math.h"

namespace prosector {
namespace {

constexpr double grid_step = 2e-3;  // s
constexpr int refinements = 12;

/// A series with linear interpolation between samples.
class Series {
 public:
  explicit Series(std::span<const TimedValue> values, std::int64_t origin_ns) {
    for (const TimedValue& v : values) {
      const double t = 1e-9 * static_cast<double>(v.time_ns - origin_ns);
      if (!times_.empty() && t <= times_.back()) continue;
      times_.push_back(t);
      values_.push_back(v.value);
    }
  }
  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }
  bool empty() const { return times_.size() < 2; }

  double at(double t) const {
    const auto upper = std::upper_bound(times_.begin(), times_.end(), t);
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        upper - times_.begin(), 1, static_cast<std::ptrdiff_t>(times_.size()) - 1));
    const double u = std::clamp((t - times_[i - 1]) / (times_[i] - times_[i - 1]), 0.0, 1.0);
    return values_[i - 1] + u * (values_[i] - values_[i - 1]);
  }

 private:
  std::vector<double> times_, values_;
};

VecX sampled(const Series& series, double from, Eigen::Index count) {
  VecX out(count);
  for (Eigen::Index i = 0; i < count; ++i) out[i] = series.at(from + grid_step * static_cast<double>(i));
  return out;
}

/// Returns the correlation of `late` with `early` at each lag of the grid within ±lags.
std::vector<double> correlations(const VecX& early, const VecX& late, Eigen::Index lags) {
  std::vector<double> out;
  const Eigen::Index n = late.size() - 2 * lags;
  const VecX b = late.segment(lags, n).array() - late.segment(lags, n).mean();
  for (Eigen::Index lag = -lags; lag <= lags; ++lag) {
    const VecX a = early.segment(lags - lag, n).array() - early.segment(lags - lag, n).mean();
    const double norm = a.norm() * b.norm();
    out.push_back(norm > 0 ? a.dot(b) / norm : 0);
  }
  return out;
}

/// Reports whether the correlation has another peak nearly as high as the best, with a valley between them.
bool ambiguous(const std::vector<double>& c, std::size_t best) {
  constexpr double nearly = 0.97, valley = 0.9;
  for (const int way : {-1, 1}) {
    double lowest = c[best];
    for (auto i = static_cast<std::ptrdiff_t>(best); i >= 0 && i < std::ssize(c); i += way) {
      const double here = c[static_cast<std::size_t>(i)];
      lowest = std::min(lowest, here);
      if (lowest < valley * c[best] && here > nearly * c[best]) return true;
    }
  }
  return false;
}

/// Returns the correlation length of the residual, in grid points.
double correlation_length(const VecX& left) {
  const double power = left.squaredNorm();
  double sum = 1;
  for (Eigen::Index lag = 1; lag < left.size() / 4; ++lag) {
    const double r = left.head(left.size() - lag).dot(left.tail(left.size() - lag)) / power;
    if (r < 0.05) break;
    sum += 2 * r;
  }
  return sum;
}

/// Refines the delay by least squares on b(t) = g·a(t − τ) + c.
void refine(const Series& early, const Series& late, double from, Eigen::Index count, DelayFit& fit) {
  const VecX b = sampled(late, from, count);
  for (int k = 0; k < refinements; ++k) {
    const VecX a = sampled(early, from - fit.delay, count);
    const VecX slope = (sampled(early, from - fit.delay + grid_step, count) -
                        sampled(early, from - fit.delay - grid_step, count)) /
                       (2 * grid_step);
    Eigen::MatrixX3d m(count, 3);
    m.col(0) = -slope;
    m.col(1) = a;
    m.col(2).setOnes();
    // The problem is linear in the unknowns g·τ', g, c.
    const Vec3 x = (m.transpose() * m).ldlt().solve(m.transpose() * b);
    fit.gain = x[1];
    const double step = x[1] != 0 ? x[0] / x[1] : 0;
    fit.delay += std::clamp(step, -0.02, 0.02);
    const VecX left = b - m * x;
    const double variance = left.squaredNorm() / static_cast<double>(count);
    const double power = slope.squaredNorm() * x[1] * x[1];
    fit.error = std::sqrt(variance * correlation_length(left) / power);
    if (std::abs(step) < 1e-7) break;
  }
}

}  // namespace

DelayFit fit_delay(std::span<const TimedValue> early, std::span<const TimedValue> late,
                   const DelayLimits& limits) {
  if (early.empty() || late.empty())
    throw InputError("one of the two devices sent no data: check both devices");
  const std::int64_t origin = early.front().time_ns;
  const Series a(early, origin), b(late, origin);
  const double from = a.empty() || b.empty() ? 0 : std::max(a.begin(), b.begin());
  const double to = a.empty() || b.empty() ? 0 : std::min(a.end(), b.end());
  DelayFit fit;
  fit.seconds = to - from;
  if (fit.seconds < limits.least_overlap + 2 * limits.longest)
    throw InputError(fmt::format("the data of both devices together cover {:.1f} s: {:.1f} s are needed",
                                 std::max(fit.seconds, 0.0), limits.least_overlap + 2 * limits.longest));
  const auto count = static_cast<Eigen::Index>(fit.seconds / grid_step);
  const auto lags = static_cast<Eigen::Index>(limits.longest / grid_step);
  const std::vector<double> c = correlations(sampled(a, from, count), sampled(b, from, count), lags);
  const auto best = static_cast<std::size_t>(std::max_element(c.begin(), c.end()) - c.begin());
  fit.correlation = c[best];
  if (fit.correlation < limits.least_correlation)
    throw InputError(
        fmt::format("the two devices do not report the same motion (correlation {:.2f}, {:.2f} is needed): "
                    "move both together, back and forth",
                    fit.correlation, limits.least_correlation));
  if (ambiguous(c, best))
    throw InputError(
        "the motion is periodic within the longest delay: move unevenly, sometimes fast, sometimes slow");
  fit.delay = grid_step * (static_cast<double>(best) - static_cast<double>(lags));
  refine(a, b, from + limits.longest, count - 2 * lags, fit);
  return fit;
}

}  // namespace prosector
