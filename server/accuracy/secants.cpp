#include "server/accuracy/secants.h"

#include <vector>

namespace prosector {
namespace {

constexpr std::size_t most_pairs = 6;
constexpr double least_curvature = 1e-12;  // cosine between step and change

}  // namespace

void Secants::remember(const VecX& step, const VecX& change) {
  const double curvature = step.dot(change);
  if (!(curvature > least_curvature * step.norm() * change.norm())) return;
  if (pairs_.size() == most_pairs) pairs_.pop_front();
  pairs_.push_back({step, change, curvature});
}

VecX Secants::direction(const VecX& gradient, const std::function<VecX(const VecX& r)>& solve) const {
  VecX q = -gradient;
  std::vector<double> along(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    along[k] = pairs_[k].step.dot(q) / pairs_[k].curvature;
    q -= along[k] * pairs_[k].change;
  }
  VecX out = solve(q);
  for (std::size_t k = 0; k < pairs_.size(); ++k)
    out += (along[k] - pairs_[k].change.dot(out) / pairs_[k].curvature) * pairs_[k].step;
  return out;
}

}  // namespace prosector
