#include "tests/bench/earlier_reports.h"

#include <fmt/format.h>

#include <fstream>

#include "common/error.h"

namespace prosector {

std::vector<ReportRow> read_reports(const std::string& bench, const std::vector<std::string>& files) {
  std::vector<ReportRow> reports;
  for (const std::string& file : files) {
    std::ifstream in(file);
    const ReportRow& report = reports.emplace_back(ReportRow::parse(in, nullptr, false));
    if (!report.is_object() || report.value("bench", "") != bench || !report.contains("rows"))
      throw InputError(fmt::format("{}: not a report of `prosector-bench {} --json`", file, bench));
  }
  return reports;
}

ReportRow origins(const std::vector<ReportRow>& reports) {
  ReportRow all = ReportRow::array();
  for (const ReportRow& report : reports)
    all.push_back({{"machine", report["machine"]}, {"date", report["date"]}, {"commit", report["commit"]}});
  return all;
}

}  // namespace prosector
