#include "tests/bench/report.h"

#include <fstream>
#include <limits>
#include <stdexcept>

#include "tests/bench/machine.h"

namespace prosector {

nlohmann::ordered_json Report::json() const {
  nlohmann::ordered_json report = {{"bench", bench_},
                                   {"machine", machine()},
                                   {"compiler", compiler()},
                                   {"date", utc_date()},
                                   {"commit", commit()}};
  report.update(notes_);
  report["rows"] = rows_;
  return report;
}

void Report::write(const std::string& file) const {
  // JSON has no infinities: the library writes non-finite numbers as null.
  if (!(std::ofstream(file) << json().dump(2) << "\n")) throw std::runtime_error("cannot write " + file);
}

double figure(const ReportRow& row, std::string_view key) {
  const auto at = row.find(key);
  return at != row.end() && at->is_number() ? at->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string setting(const ReportRow& row, std::string_view key) {
  const auto at = row.find(key);
  return at != row.end() && at->is_string() ? at->get<std::string>() : std::string();
}

}  // namespace prosector
