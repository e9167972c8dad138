#include "drivers/files/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "common/error.h"
#include "common/regular_file.h"

namespace prosector {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    const auto comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file, const std::vector<std::string>& known) : file_(file) {
  constexpr std::size_t max_bytes = std::size_t{1} << 28;
  std::istringstream in(read_regular_file(file, max_bytes));
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (const std::string t = trimmed(line); t.empty() || t[0] == '#') continue;
    rows_.push_back({number, split(line)});
    if (columns_.empty()) {
      columns_ = rows_.back().cells;
      for (const std::string& c : columns_) {
        if (std::find(known.begin(), known.end(), c) == known.end())
          fail(0, fmt::format("unknown column '{}'; allowed: {}", c, fmt::join(known, ", ")));
        if (std::count(columns_.begin(), columns_.end(), c) > 1)
          fail(0, fmt::format("duplicate column '{}'", c));
      }
      rows_.clear();
    } else if (rows_.back().cells.size() != columns_.size()) {
      fail(rows_.size() - 1, fmt::format("the row has {} cells, but the header has {} columns",
                                         rows_.back().cells.size(), columns_.size()));
    }
  }
  if (rows_.empty()) throw InputError(fmt::format("{}: no rows", file.string()));
}

std::optional<std::size_t> CsvTable::find(std::string_view column) const {
  const auto at = std::find(columns_.begin(), columns_.end(), column);
  if (at == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - columns_.begin());
}

std::string_view CsvTable::text(std::size_t row, std::string_view column) const {
  const auto at = find(column);
  return at ? std::string_view(rows_[row].cells[*at]) : std::string_view();
}

std::optional<double> CsvTable::number(std::size_t row, std::string_view column) const {
  const std::string_view cell = text(row, column);
  if (cell.empty()) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
    fail(row, fmt::format("{}: '{}' is not a finite number", column, cell));
  return value;
}

double CsvTable::required(std::size_t row, std::string_view column) const {
  const auto value = number(row, column);
  if (!value) fail(row, fmt::format("{}: must be a number", column));
  return *value;
}

void CsvTable::fail(std::size_t row, const std::string& what) const {
  throw InputError(fmt::format("{}:{}: {}", file_.string(), rows_[row].line, what));
}

}  // namespace prosector
