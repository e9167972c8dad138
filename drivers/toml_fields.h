#pragma once
// A small TOML file as its reader asks for it, key by key; what nobody asked for is an error.
//
// Each error is an InputError with file, line and key, and says what is allowed.

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
  /// Reads a text of that kind, as "board"; `file` is for messages, and what it names is looked for beside
  /// it.
  static TomlFields parse(const std::string& toml, const std::filesystem::path& file,
                          const std::string& kind);
  static TomlFields load(const std::filesystem::path& file, const std::string& kind);

  bool has(std::string_view key) const;
  /// Returns what a key says, as do the next ones. Without `otherwise` it must be there.
  double number(std::string_view key, double least, double most) const;
  double number(std::string_view key, double least, double most, double otherwise) const;
  int whole(std::string_view key, int least, int most) const;
  int whole(std::string_view key, int least, int most, int otherwise) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::string text(std::string_view key) const;
  std::string text(std::string_view key, const std::string& otherwise) const;
  /// Reads as many numbers as `out` has places.
  void numbers(std::string_view key, std::span<double> out, double least, double most) const;
  /// Reads `position` (m) and `orientation` (w, x, y, z), each of which may be missing.
  Pose pose() const;
  /// Reads a file's name, which is looked for beside this file.
  std::filesystem::path file(std::string_view key) const;
  /// Returns the table of that name, or all of a list of tables; none where the key isn't.
  std::vector<TomlFields> tables(std::string_view key) const;
  /// Throws where there is a key that nobody asked for.
  void refuse_others() const;
  [[noreturn]] void fail(std::string_view key, const std::string& what) const;

 private:
  struct Text;
  struct Table;
  explicit TomlFields(std::shared_ptr<const Table> table) : table_(std::move(table)) {}

  std::shared_ptr<const Table> table_;
};

}  // namespace prosector
