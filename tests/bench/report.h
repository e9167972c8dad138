#pragma once
// The JSON report that every bench writes: an object with `bench`, `machine`, `compiler`, `date`, `commit`
// and `rows`. A row holds settings (`model`, `element`, `integrator`, `solver`, `tets`, `nodes`, `dt`,
// `threads`, …) and figures (`ms_per_frame`, `steps_per_s`, `error_mesh`, `error_continuum`, `residual`,
// `verdict`, …): SI units, or the unit in the name; errors are fractions of the right value. A figure that is
// not finite or was not measured is null.

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace prosector {

/// What an extreme did to a rung.
enum class Verdict {
  survives,  // finite, no energy out of nothing, the shape is back, nothing to report
  degrades,  // the same, but accuracy was lost or a body was reset, and the step's report said so
  refuses,   // said before running that it won't, and why
  fails,     // none of these, or wrong without saying so
};
inline constexpr std::array verdict_names = {"survives", "degrades", "refuses", "fails"};
constexpr const char* verdict_name(Verdict verdict) {
  return verdict_names[static_cast<std::size_t>(verdict)];
}

/// Keys keep their order.
using ReportRow = nlohmann::ordered_json;

class Report {
 public:
  explicit Report(std::string bench) : bench_(std::move(bench)) {}
  void add(ReportRow row) { rows_.push_back(std::move(row)); }
  /// More about the run as a whole, beside `rows`.
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

/// The row's number under that key; not a number when there is none.
double figure(const ReportRow& row, std::string_view key);
/// Its text; empty when there is none.
std::string setting(const ReportRow& row, std::string_view key);

}  // namespace prosector
