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
  /// Parses TOML text. `kind` is the kind of file, such as "board", for messages. `file` is the path that
  /// messages name; referenced files are resolved relative to its folder. Throws InputError for invalid TOML.
  static TomlFields parse(const std::string& toml, const std::filesystem::path& file,
                          const std::string& kind);
  static TomlFields load(const std::filesystem::path& file, const std::string& kind);

  bool has(std::string_view key) const;
  /// Returns the number at a key, which must be present and from `least` to `most`. Throws InputError
  /// otherwise.
  double number(std::string_view key, double least, double most) const;
  double number(std::string_view key, double least, double most, double otherwise) const;
  int whole(std::string_view key, int least, int most) const;
  int whole(std::string_view key, int least, int most, int otherwise) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text(std::string_view key, const std::string& otherwise) const;
  /// Reads a required array of exactly `out.size()` numbers from `least` to `most` into `out`. Throws
  /// InputError otherwise.
  void numbers(std::string_view key, std::span<double> out, double least, double most) const;
  /// Reads the optional keys `position` (m) and `orientation` (unit quaternion w, x, y, z) of this table.
  /// Missing keys give zero and the identity.
  Pose pose() const;
  /// Returns the path of a file that the required text at `key` names relative to the folder of the parsed
  /// TOML file.
  std::filesystem::path file(std::string_view key) const;
  /// Returns the table at `key`, or all tables if an array of tables is there. Returns an empty list if the
  /// key is missing.
  std::vector<TomlFields> tables(std::string_view key) const;
  /// Throws InputError if this table contains a key that the caller has never requested, since that key is
  /// unknown.
  void reject_unknown_keys() const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  struct Text;
  struct Table;
  explicit TomlFields(std::shared_ptr<const Table> table) : table_(std::move(table)) {}

  std::shared_ptr<const Table> table_;
};

}  // namespace prosector
