#include "server/calibration/bend_reference.h"

#include <algorithm>

namespace prosector {
namespace {

struct Sag {
  const char* model;
  double at_0_30, at_0_45;  // m
};
constexpr Sag continuum[] = {{"fem_linear", .13095, .12816},
                             {"fem_corotational", .12275, .1206},
                             {"fem_neo_hookean_polynomial", .12322, .12103},
                             {"fem_neo_hookean", .12308, .12087}};
constexpr Sag tissue = continuum[3];

double of(const Sag& row, double poisson_ratio) {
  return poisson_ratio < 0.4 ? row.at_0_30 : row.at_0_45;
}

}  // namespace

std::optional<double> continuum_sag(const std::string& model, double poisson_ratio) {
  const auto* row = std::find_if(std::begin(continuum), std::end(continuum),
                                 [&](const Sag& sag) { return sag.model == model; });
  if (row == std::end(continuum)) return std::nullopt;
  return of(*row, poisson_ratio);
}

double tissue_sag(double poisson_ratio) {
  return of(tissue, poisson_ratio);
}

}  // namespace prosector
