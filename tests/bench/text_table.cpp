#include "tests/bench/text_table.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace prosector {
namespace {

std::string cell(const Column& column, const ReportRow& row) {
  if (column.kind == Column::Kind::text) return setting(row, column.key);
  const double value = figure(row, column.key);
  if (!std::isfinite(value)) return "-";
  if (column.kind == Column::Kind::count) return fmt::format("{:.0f}", value);
  if (column.kind == Column::Kind::fixed) return fmt::format("{:.6f}", value);
  if (column.kind == Column::Kind::percent) return three_digits(100 * value) + " %";
  return three_digits(value);
}

}  // namespace

std::string three_digits(double value) {
  if (!std::isfinite(value)) return "-";
  const double size = std::abs(value);
  if (size == 0) return "0";
  if (size >= 1e7 || size < 1e-4) return fmt::format("{:.1e}", value);
  const int decimals = std::max(0, 2 - static_cast<int>(std::floor(std::log10(size))));
  return fmt::format("{:.{}f}", value, decimals);
}

TextTable::TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {
  for (Column& column : columns_)
    column.width = std::max(column.width, static_cast<int>(column.heading.size()));
}

std::string TextTable::header() const {
  std::string line;
  for (const Column& c : columns_) {
    line += c.kind == Column::Kind::text ? fmt::format("{:<{}}  ", c.heading, c.width)
                                         : fmt::format("{:>{}}  ", c.heading, c.width);
  }
  return line;
}

std::string TextTable::line(const ReportRow& row) const {
  std::string line;
  for (const Column& c : columns_) {
    line += c.kind == Column::Kind::text ? fmt::format("{:<{}}  ", cell(c, row), c.width)
                                         : fmt::format("{:>{}}  ", cell(c, row), c.width);
  }
  return line;
}

void TextTable::print_header() const {
  fmt::print("{}\n", header());
  std::fflush(stdout);
}

void TextTable::print(const ReportRow& row) const {
  fmt::print("{}\n", line(row));
  std::fflush(stdout);
}

}  // namespace prosector
