#include "server/calibration/bend_reference.h"

#include <algorithm>
#include <stdexcept>

namespace prosector {
namespace {

struct Sag {
  const char* model;
  std::array<double, bend_ratios.size()> at_ratio;  // m
};
constexpr Sag continuum[] = {{"fem_linear", {.13095, .12816, .1270, .1268}},
                             {"fem_corotational", {.12275, .1206, .1196, .1195}},
                             {"fem_neo_hookean_polynomial", {.12322, .12103, .1201, .1200}},
                             {"fem_neo_hookean", {.12308, .12087, .1200, .1199}}};
constexpr Sag tissue = continuum[3];

double of(const Sag& row, double poisson_ratio) {
  const auto at = std::find(bend_ratios.begin(), bend_ratios.end(), poisson_ratio);
  if (at == bend_ratios.end())
    throw std::logic_error("the bending benchmark has no reference deflection for this Poisson ratio");
  return row.at_ratio[static_cast<std::size_t>(at - bend_ratios.begin())];
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
