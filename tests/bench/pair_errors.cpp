#include "tests/bench/pair_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/calibration/stopwatch.h"

namespace prosector {
namespace {

double median_or_nothing(const std::vector<double>& values) {
  return values.empty() ? std::nan("") : median(values);
}

double share(int part, int whole) {
  return whole > 0 ? static_cast<double>(part) / whole : std::nan("");
}

}  // namespace

void keep_deepest(std::optional<PairContact>& kept, const PairContact& found) {
  if (!kept || found.gap < kept->gap) kept = found;
}

void PairErrors::add(const std::optional<PairContact>& found,
                     const std::optional<collision::Proximity>& truth) {
  const bool told = found && found->gap <= 0, hit = truth && truth->gap <= 0;
  ++pairs_;
  hits_ += hit ? 1 : 0;
  false_hits_ += told && !hit ? 1 : 0;
  missed_ += !told && hit ? 1 : 0;
  if (!told || !hit) return;
  depths_.push_back(std::abs(found->gap - truth->gap) / size_);
  const double cosine = std::clamp(found->normal.dot(truth->normal), -1., 1.);
  normals_.push_back(std::acos(cosine) * 180 / std::numbers::pi);
}

void PairErrors::tell(ReportRow& row) const {
  row["pairs"] = pairs_;
  row["hits"] = hits_;
  row["false_hits"] = share(false_hits_, pairs_ - hits_);
  row["missed_hits"] = share(missed_, hits_);
  row["depth_error"] = median_or_nothing(depths_);
  row["normal_error_deg"] = median_or_nothing(normals_);
}

}  // namespace prosector
