#pragma once
// Opens a SQLite file wherever it lies: on a medium that can't be written, or in somebody else's folder.

#include <filesystem>
#include <memory>

#include "server/session/sqlite.h"

namespace prosector {

/// Opens the file to read. Throws SqliteError when there is no way to read it.
std::unique_ptr<SqliteDatabase> open_to_read(const std::filesystem::path& file);

}  // namespace prosector
