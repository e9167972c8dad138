#pragma once
// SQLite with RAII and exceptions; the only place that includes its header is sqlite.cpp.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace prosector {

/// An error that SQLite reported, with SQLite's message, such as "database or disk is full".
class SqliteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class SqliteDatabase {
 public:
  // Mode write creates the file when there is none. Mode unchanging reads a file that nothing can write
  // meanwhile, such as one on a read-only medium, where SQLite can't create its locks.
  enum class Mode : std::uint8_t { read, unchanging, write };
  SqliteDatabase(const std::filesystem::path& file, Mode mode);
  ~SqliteDatabase();
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  void execute(const std::string& sql);
  sqlite3* handle() const { return handle_; }

 private:
  sqlite3* handle_ = nullptr;
};

/// A prepared SQL statement. Parameters and columns are counted from 0.
class SqliteStatement {
 public:
  SqliteStatement(SqliteDatabase& database, const std::string& sql);
  ~SqliteStatement();
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;

  SqliteStatement& bind(int parameter, std::uint64_t value);
  SqliteStatement& bind(int parameter, const std::string& value);
  SqliteStatement& bind(int parameter, std::span<const std::uint8_t> value);
  /// Runs the SQL statement to its next row. Returns whether there is one. If not, the statement is done and
  /// is reset for its next use.
  bool step();

  std::uint64_t number(int column) const;
  std::string text(int column) const;
  std::vector<std::uint8_t> bytes(int column) const;

 private:
  SqliteDatabase& database_;
  sqlite3_stmt* statement_ = nullptr;
};

}  // namespace prosector
