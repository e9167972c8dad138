#include "server/session/journal/readable_database.h"

#include <stdlib.h>

namespace prosector {
namespace {

namespace fs = std::filesystem;

/// A new temporary folder, which the destructor removes.
struct TemporaryFolder {
  fs::path path;
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "prosector-journal.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw SqliteError("cannot create a temporary folder");
    path = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// Opens a copy. The write-ahead log can't be merged where it is stored, so it is merged into the copy. The
/// copy stays readable while it is open, although its folder is removed.
std::unique_ptr<SqliteDatabase> open_copy(const fs::path& file, const fs::path& log) {
  const TemporaryFolder folder;
  const fs::path copy = folder.path / "journal";
  std::error_code error;
  fs::copy_file(file, copy, error);
  if (!error) fs::copy_file(log, copy.string() + "-wal", error);
  if (!error) fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, error);
  if (!error) fs::permissions(copy.string() + "-wal", fs::perms::owner_read | fs::perms::owner_write, error);
  if (error) throw SqliteError("cannot be copied to " + folder.path.string() + ": " + error.message());
  auto database = std::make_unique<SqliteDatabase>(copy, SqliteDatabase::Mode::write);
  database->execute("PRAGMA journal_mode=DELETE");
  return database;
}

}  // namespace

std::unique_ptr<SqliteDatabase> open_to_read(const fs::path& file) {
  auto database = std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::read);
  try {
    database->execute("SELECT 1 FROM sqlite_schema");
    return database;
  } catch (const SqliteError&) {
    // Not a database, or no write access for SQLite's locks: only the latter is handled below.
  }
  database.reset();
  const fs::path log = file.string() + "-wal";
  std::error_code none;
  const auto log_bytes = fs::file_size(log, none);
  if (!none && log_bytes > 0) return open_copy(file, log);
  return std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::unchanging);
}

}  // namespace prosector
