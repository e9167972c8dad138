// Each integrator on a spring, without energy safeguard: order of convergence, stability limit, and growth or
// decay, with theory.

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>

#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/oscillator.h"

namespace prosector {
namespace {

using Complex = std::complex<double>;

/// Returns the theoretical amplification factor of e^(iωt) in a step of ωh = z.
Complex amplification_factor(const std::string& name, double z) {
  const Complex w(0, z);
  // Eigenvalue for x″ = −x as two first-order equations; for kick and drift, g + 1/g = 2 − z².
  if (name == "symplectic_euler" || name == "verlet")
    return Complex(1 - z * z / 2, z * std::sqrt(1 - z * z / 4));
  if (name == "explicit_euler") return 1. + w;
  if (name == "rk2") return 1. + w + w * w / 2.;
  if (name == "rk4") return 1. + w + w * w / 2. + w * w * w / 6. + w * w * w * w / 24.;
  if (name == "implicit_euler") return 1. / (1. - w);
  if (name == "bdf2") return (2. + std::sqrt(1. + 2. * w)) / (3. - 2. * w);
  const double c = 2 - std::sqrt(2.);  // TR-BDF2 (Hosea & Shampine 1996)
  return (2 * (2 - c) + (1 + (1 - c) * (1 - c)) * w) / (c * (1 - c) * w * w + (c * c - 2) * w + 2 * (2 - c));
}

/// Returns the theoretical stability limit of ωh; infinite: unconditionally stable.
double limit_in_theory(const std::string& name) {
  if (name == "explicit_euler" || name == "rk2") return 0;
  if (name == "symplectic_euler" || name == "verlet") return 2;
  if (name == "rk4") return std::sqrt(8.);
  return std::numeric_limits<double>::infinity();
}

/// Returns the observed stability limit, by bisection. Stability at `any` counts as unconditional.
double limit_observed(const OscillatorMethod& method) {
  constexpr double any = 1e4, least = 0.5;  // smaller steps grow too slowly to detect
  if (holds(method, any)) return std::numeric_limits<double>::infinity();
  if (!holds(method, least)) return 0;
  double low = least, high = 10;
  while (high - low > 1e-3) (holds(method, (low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

std::string step_limit(double z) {
  if (z == 0) return "unstable";
  return std::isfinite(z) ? fmt::format("{:.3f}", z) : "any stable";
}

ReportRow measure(const OscillatorMethod& method, double z) {
  const auto [growth, frequency] = amplification(method, z);
  const Complex right = amplification_factor(method.name, z);
  ReportRow row = {{"model", "spring"},
                   {"integrator", method.name},
                   {"omega_dt", z},
                   {"order", observed_order(method, 0)},
                   {"order_theory", method.order},
                   {"growth_per_step", growth},
                   {"growth_per_step_theory", std::abs(right)},
                   {"growth_100_steps", std::pow(growth, 100)},
                   {"frequency_ratio", frequency},
                   {"frequency_ratio_theory", std::arg(right) / z}};
  row["largest_omega_dt"] = limit_observed(method);
  row["largest_omega_dt_theory"] = limit_in_theory(method.name);
  row["holds"] = step_limit(row["largest_omega_dt"]);
  row["holds_theory"] = step_limit(row["largest_omega_dt_theory"]);
  return row;
}

}  // namespace

Report bench_integrators() {
  fmt::print(
      "undamped spring, no energy safeguard; amplitude growth in 1 and 100 steps; frequency relative to the "
      "exact one; with theory\n");
  using enum Column::Kind;
  const TextTable table({{text, "integrator", "integrator", 17},
                         {number, "omega_dt", "ωh", 6},
                         {number, "order", "order", 6},
                         {count, "order_theory", "theory"},
                         {text, "holds", "largest ωh", 10},
                         {text, "holds_theory", "theory", 10},
                         {fixed, "growth_per_step", "growth", 8},
                         {fixed, "growth_per_step_theory", "theory", 8},
                         {number, "growth_100_steps", "in 100", 8},
                         {fixed, "frequency_ratio", "frequency", 8},
                         {fixed, "frequency_ratio_theory", "theory", 8}});
  table.print_header();
  Report report("integrators");
  for (const OscillatorMethod& method : oscillator_methods())
    for (const double z : {0.1, 0.5}) {
      report.add(measure(method, z));
      table.print(report.rows().back());
    }
  return report;
}

}  // namespace prosector
