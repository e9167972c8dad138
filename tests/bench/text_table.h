#pragma once
// Prints report rows as aligned text while a benchmark runs.

#include <string>
#include <vector>

#include "tests/bench/report.h"

namespace prosector {

struct Column {
  enum class Kind { text, count, number, fixed, percent } kind;  // fixed: six decimals
  std::string key;                                               // key in the report row
  std::string heading;                                           // column heading, with unit
  int width = 0;  // minimum width in characters; at least the heading's
};

class TextTable {
 public:
  explicit TextTable(std::vector<Column> columns);
  /// Returns the heading line. Numbers in lines have three significant digits; missing or non-finite ones are
  /// printed as a dash.
  std::string header() const;
  std::string line(const ReportRow& row) const;
  /// Prints the heading line to standard output and flushes it.
  void print_header() const;
  void print(const ReportRow& row) const;

 private:
  std::vector<Column> columns_;
};

/// Formats a number with three significant digits: 0.0123, 1.23, 123, 12300, 1.2e-07.
std::string three_digits(double value);

}  // namespace prosector
