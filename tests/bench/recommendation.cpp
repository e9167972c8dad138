#include "tests/bench/recommendation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tests/bench/text_table.h"
#include "tests/bench/trade_case.h"
#include "tests/bench/trade_plot.h"

namespace prosector {
namespace {

constexpr double budgets_ms[] = {1, 4, 8, 16};
constexpr double accuracies[] = {0.01, 0.02, 0.05, 0.10};

/// Returns the best row (by `better`) among the allowed ones; null if there is none.
template <class Allowed, class Better>
const ReportRow* best(const std::vector<const ReportRow*>& rows, const Allowed& allowed,
                      const Better& better) {
  const ReportRow* chosen = nullptr;
  for (const ReportRow* row : rows) {
    if (allowed(*row) && (!chosen || better(*row, *chosen))) chosen = row;
  }
  return chosen;
}

/// Returns whether a finer mesh at least doubles the error, which means that two errors cancel here.
template <class Error>
bool right_by_chance(const ReportRow& row, const std::vector<const ReportRow*>& rows, bool moving,
                     const Error& error) {
  const auto alike = [&](const ReportRow& other) {
    return setting(other, "model") == setting(row, "model") &&
           setting(other, "element") == setting(row, "element") &&
           (!moving || setting(other, "integrator") == setting(row, "integrator")) &&
           figure(other, "dt_ms") == figure(row, "dt_ms");
  };
  std::map<double, double> least;  // least error by number of tetrahedra
  for (const ReportRow* other : rows) {
    if (!alike(*other)) continue;
    const auto [at, is_new] = least.try_emplace(figure(*other, "tets"), error(*other));
    if (!is_new) at->second = std::min(at->second, error(*other));
  }
  const auto finer = least.upper_bound(figure(row, "tets"));
  return std::any_of(finer, least.end(), [&](const auto& mesh) { return mesh.second > 2 * error(row); });
}

std::string told(const ReportRow& row, const char* error_key) {
  return fmt::format("{}: {} ms per frame, error {} %", in_words(row),
                     three_digits(figure(row, "ms_per_frame")),
                     three_digits(100 * std::abs(figure(row, error_key))));
}

}  // namespace

std::string in_words(const ReportRow& row) {
  std::string effort = setting(row, "effort");
  const double iterations = figure(row, "solver_iterations");
  if (effort.empty() && std::isfinite(iterations)) effort = fmt::format("× {:.0f}", iterations);
  return fmt::format("{} {}, {}, {} {}, {:.0f} tets, dt {} ms", setting(row, "model"),
                     setting(row, "element"), setting(row, "integrator"), setting(row, "solver"), effort,
                     figure(row, "tets"), three_digits(figure(row, "dt_ms")));
}

std::vector<std::string> recommend(const std::vector<ReportRow>& rows) {
  std::vector<std::string> lines;
  for (const TradeCase* which : trade_cases()) {
    std::vector<const ReportRow*> measured;
    for (const ReportRow& row : rows) {
      const bool is_ours = !setting(row, "model").starts_with("bullet_");
      if (is_ours && setting(row, "case") == which->name && std::isfinite(figure(row, which->error_key)))
        measured.push_back(&row);
    }
    if (measured.empty()) continue;
    const auto error = [&](const ReportRow& row) {
      return std::max(std::abs(figure(row, which->error_key)), negligible_error);
    };
    const auto cost = [](const ReportRow& row) { return figure(row, "ms_per_frame"); };
    const std::vector<const ReportRow*> all = measured;
    std::erase_if(measured,
                  [&](const ReportRow* row) { return right_by_chance(*row, all, which->moving, error); });
    lines.push_back(fmt::format("{} ({}):", which->name, which->title));
    for (const double accuracy : accuracies) {
      const ReportRow* row = best(
          measured, [&](const ReportRow& r) { return error(r) <= accuracy; },
          [&](const ReportRow& a, const ReportRow& b) { return cost(a) < cost(b); });
      lines.push_back(fmt::format("  within {:.0f} %: {}", 100 * accuracy,
                                  row ? told(*row, which->error_key) : "no run"));
    }
    for (const double budget : budgets_ms) {
      const ReportRow* row = best(
          measured, [&](const ReportRow& r) { return cost(r) <= budget; },
          [&](const ReportRow& a, const ReportRow& b) {
            return std::pair(error(a), cost(a)) < std::pair(error(b), cost(b));
          });
      lines.push_back(
          fmt::format("  within {:.0f} ms: {}", budget, row ? told(*row, which->error_key) : "no run"));
    }
  }
  return lines;
}

}  // namespace prosector
