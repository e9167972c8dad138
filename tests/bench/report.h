#pragma once
// The JSON report of every benchmark: an object with `bench`, `machine`, `compiler`, `date`, `commit`
// and `rows`. A row holds settings (`model`, `element`, `integrator`, `solver`, `tets`, `nodes`, `dt`,
// `threads`, …) and figures (`ms_per_frame`, `steps_per_s`, `error_mesh`, `error_continuum`, `residual`,
// `verdict`, …): SI units, or the unit in the name; errors are fractions of the reference value. A figure
// that is not finite or was not measured is null.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace prosector {

/// Verdict of a test.
enum class Verdict {
  survives,  // passed: finite, no energy gain, shape recovered, no loss reported
  degrades,  // lost accuracy or reset a body, and the step report said so
  refuses,   // rejected before the run, with a reason
  fails,     // anything else, e.g. wrong without a report
};
inline constexpr std::array verdict_names = {"survives", "degrades", "refuses", "fails"};
constexpr const char* verdict_name(Verdict verdict) {
  return verdict_names[static_cast<std::size_t>(verdict)];
}

/// One row of a report; keys keep their order.
using ReportRow = nlohmann::ordered_json;

class Report {
 public:
  explicit Report(std::string bench) : bench_(std::move(bench)) {}
  void add(ReportRow row) { rows_.push_back(std::move(row)); }
  /// Adds a top-level entry about the whole run, next to `rows`.
  void note(const std::string& key, nlohmann::ordered_json value) { notes_[key] = std::move(value); }
  const std::vector<ReportRow>& rows() const { return rows_; }
  nlohmann::ordered_json json() const;
  /// Throws std::runtime_error when the file can't be written.
  void write(const std::string& file) const;

 private:
  std::string bench_;
  std::vector<ReportRow> rows_;
  nlohmann::ordered_json notes_ = nlohmann::ordered_json::object();
};

/// Returns the number stored under `key`; NaN if there is none.
double figure(const ReportRow& row, std::string_view key);
/// Returns the text stored under `key`; empty if there is none.
std::string setting(const ReportRow& row, std::string_view key);

}  // namespace prosector
