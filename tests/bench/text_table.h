#pragma once
// Report rows as lines of aligned text, printed one by one while a bench runs.

#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

struct Column {
  enum class Kind { text, count, number, fixed, percent } kind;  // fixed: six decimals
  std::string key;                                               // of the row
  std::string heading;                                           // with the unit
  int width = 0;  // characters at least; the heading always fits
};

class TextTable {
 public:
  explicit TextTable(std::vector<Column> columns);
  /// Numbers to three digits that count; a dash for what was not measured or is not finite.
  std::string header() const;
  std::string line(const ReportRow& row) const;
  /// To standard output, at once.
  void print_header() const;
  void print(const ReportRow& row) const;

 private:
  std::vector<Column> columns_;
};

/// Three digits that count: 0.0123, 1.23, 123, 12300, 1.2e-07.
std::string three_digits(double value);

}  // namespace prosector
