#pragma once
// Small CSV files. A header line names the columns; '#' starts a comment line.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prosector {

class CsvTable {
 public:
  /// Reads a CSV file with a header line; `known` lists the allowed column names. Throws InputError with file
  /// and line if the file is unreadable or has no rows, columns are unknown or repeated, or a row has the
  /// wrong length.
  CsvTable(const std::filesystem::path& file, const std::vector<std::string>& known);

  std::size_t rows() const { return rows_.size(); }
  bool has(std::string_view column) const { return find(column).has_value(); }
  /// Returns the text of a cell in `row`, counted from 0 without the header. Returns an empty text if the
  /// table has no such column.
  std::string_view text(std::size_t row, std::string_view column) const;
  /// Returns the number in a cell, or nothing if the cell is empty or the table has no such column. Throws
  /// InputError with file and line if the text is not a finite number.
  std::optional<double> number(std::size_t row, std::string_view column) const;
  /// Returns the number in a cell that must not be empty. Throws InputError with file and line if it is empty
  /// or not a finite number.
  double required(std::size_t row, std::string_view column) const;
  [[noreturn]] void fail(std::size_t row, const std::string& what) const;

 private:
  struct Row {
    std::size_t line;
    std::vector<std::string> cells;
  };
  std::optional<std::size_t> find(std::string_view column) const;

  std::filesystem::path file_;
  std::vector<std::string> columns_;
  std::vector<Row> rows_;
};

}  // namespace prosector
