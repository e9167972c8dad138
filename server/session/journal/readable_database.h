#pragma once
// Opens a SQLite file for reading wherever it is stored: also on a read-only medium, or in a folder without
// write access.

#include <filesystem>
#include <memory>

#include "server/session/journal/sqlite.h"

namespace prosector {

/// Opens a SQLite file for reading, also on a read-only medium or in a folder without write access. Throws
/// SqliteError if it can't be read.
std::unique_ptr<SqliteDatabase> open_to_read(const std::filesystem::path& file);

}  // namespace prosector
