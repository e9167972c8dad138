#include "server/session/journal/sqlite.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <bit>
#include <cctype>

namespace prosector {
namespace {

void check(int code, sqlite3* database) {
  if (code != SQLITE_OK) throw SqliteError(database != nullptr ? sqlite3_errmsg(database) : "out of memory");
}

/// Returns SQLite's URI of the file. Characters other than letters, digits and `/.-_` are escaped.
std::string uri_of(const std::filesystem::path& file, const std::string& parameters) {
  std::string out = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_';
    out += plain ? std::string(1, c) : fmt::format("%{:02x}", byte);
  }
  return out + "?" + parameters;
}

}  // namespace

SqliteDatabase::SqliteDatabase(const std::filesystem::path& file, Mode mode) {
  const bool writes = mode == Mode::write;
  const int flags =
      SQLITE_OPEN_NOMUTEX | (writes ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY);
  const int code = mode == Mode::unchanging ? sqlite3_open_v2(uri_of(file, "immutable=1").c_str(), &handle_,
                                                              flags | SQLITE_OPEN_URI, nullptr)
                                            : sqlite3_open_v2(file.c_str(), &handle_, flags, nullptr);
  if (code == SQLITE_OK) {
    // The file may be untrusted: its schema must not run functions or damage the database.
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    return;
  }
  const std::string why = handle_ != nullptr ? sqlite3_errmsg(handle_) : "out of memory";
  sqlite3_close(handle_);
  throw SqliteError(why);
}

SqliteDatabase::~SqliteDatabase() {
  sqlite3_close(handle_);
}

void SqliteDatabase::execute(const std::string& sql) {
  check(sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr), handle_);
}

SqliteStatement::SqliteStatement(SqliteDatabase& database, const std::string& sql) : database_(database) {
  check(sqlite3_prepare_v2(database.handle(), sql.c_str(), -1, &statement_, nullptr), database.handle());
}

SqliteStatement::~SqliteStatement() {
  sqlite3_finalize(statement_);
}

SqliteStatement& SqliteStatement::bind(int parameter, std::uint64_t value) {
  check(sqlite3_bind_int64(statement_, parameter + 1, std::bit_cast<std::int64_t>(value)),
        database_.handle());
  return *this;
}

SqliteStatement& SqliteStatement::bind(int parameter, const std::string& value) {
  check(sqlite3_bind_text64(statement_, parameter + 1, value.data(), value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8),
        database_.handle());
  return *this;
}

SqliteStatement& SqliteStatement::bind(int parameter, std::span<const std::uint8_t> value) {
  check(sqlite3_bind_blob64(statement_, parameter + 1, value.data(), value.size(), SQLITE_TRANSIENT),
        database_.handle());
  return *this;
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(statement_);
  if (code == SQLITE_ROW) return true;
  const std::string why = code == SQLITE_DONE ? "" : sqlite3_errmsg(database_.handle());
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
  if (code != SQLITE_DONE) throw SqliteError(why);
  return false;
}

std::uint64_t SqliteStatement::number(int column) const {
  return std::bit_cast<std::uint64_t>(std::int64_t{sqlite3_column_int64(statement_, column)});
}

std::string SqliteStatement::text(int column) const {
  const std::vector<std::uint8_t> b = bytes(column);
  return {b.begin(), b.end()};
}

std::vector<std::uint8_t> SqliteStatement::bytes(int column) const {
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_, column));
  const int size = sqlite3_column_bytes(statement_, column);
  return data == nullptr ? std::vector<std::uint8_t>() : std::vector<std::uint8_t>(data, data + size);
}

}  // namespace prosector
