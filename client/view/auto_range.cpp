#include "client/view/auto_range.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double counted = 0.99;  // fraction of the values within the scale
constexpr double of_largest = 1.0 / 3;
constexpr double well_below = 0.8;  // the limit falls if values are below this fraction of a smaller limit

/// Returns the smallest limit of 1, 2 or 5 times a power of ten that is not below the value, which is
/// positive.
double end_for(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  return 10 * power;
}

}  // namespace

double AutoRange::follow(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  double reached = 0;
  if (!values.empty()) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(counted * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    reached = std::max(*place, of_largest * *std::max_element(place, values.end()));
  }
  if (reached > end_) end_ = end_for(reached);
  end_ = std::min(end_, std::max(least_, end_for(std::max(reached / well_below, least_))));
  return end_;
}

}  // namespace prosector
