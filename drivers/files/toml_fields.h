#pragma once
// Reader of a small TOML file, key by key. Keys that were never requested are errors.
//
// Each error is an InputError with file, line, key and the allowed values.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/math.h"

namespace prosector {

class TomlFields {
 public:
  /// Parses a text of a `kind` such as "board". `file` is used in messages; referenced files are resolved
  /// relative to its folder.
  static TomlFields parse(const std::string& toml, const std::filesystem::path& file,
                          const std::string& kind);
  static TomlFields load(const std::filesystem::path& file, const std::string& kind);

  bool has(std::string_view key) const;
  /// Returns a key's value, as do the next functions. Without `otherwise` the key is required.
  double number(std::string_view key, double least, double most) const;
  double number(std::string_view key, double least, double most, double otherwise) const;
  int whole(std::string_view key, int least, int most) const;
  int whole(std::string_view key, int least, int most, int otherwise) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text(std::string_view key, const std::string& otherwise) const;
  /// Reads an array of exactly `out.size()` numbers.
  void numbers(std::string_view key, std::span<double> out, double least, double most) const;
  /// Reads the optional keys `position` (m) and `orientation` (w, x, y, z).
  Pose pose() const;
  /// Reads a file name, relative to this file's folder.
  std::filesystem::path file(std::string_view key) const;
  /// Returns the table at `key`, or all tables of an array; empty if the key is missing.
  std::vector<TomlFields> tables(std::string_view key) const;
  /// Throws InputError for a key that was never requested.
  void reject_unknown_keys() const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  struct Text;
  struct Table;
  explicit TomlFields(std::shared_ptr<const Table> table) : table_(std::move(table)) {}

  std::shared_ptr<const Table> table_;
};

}  // namespace prosector
