#include "server/session/readable_database.h"

#include <stdlib.h>

namespace prosector {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
struct TemporaryFolder {
  fs::path path;
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "prosector-journal.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw SqliteError("no temporary folder can be made");
    path = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// Opens a copy. A log that nobody can work off where it lies is worked off beside the copy, which stays
/// readable while it is open, though its name goes.
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
    // No database, or no place for SQLite's locks beside it: only the latter has another way.
  }
  database.reset();
  const fs::path log = file.string() + "-wal";
  std::error_code none;
  const auto log_bytes = fs::file_size(log, none);
  if (!none && log_bytes > 0) return open_copy(file, log);
  return std::make_unique<SqliteDatabase>(file, SqliteDatabase::Mode::unchanging);
}

}  // namespace prosector
