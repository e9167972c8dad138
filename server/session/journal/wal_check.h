#pragma once
// Checks whether the write-ahead log of a SQLite file exists and is complete. SQLite itself reads a log up to
// its first damaged frame, and silently ignores the rest.

#include <filesystem>

namespace prosector {

/// Returns whether the log has commits beyond the part that its checksums verify. A crash leaves none there.
bool log_is_damaged(const std::filesystem::path& log);

/// Returns whether `file` uses a write-ahead log and none exists: it was copied without. Must not be called
/// by a process that has the file open: closing it here would release that process's locks.
bool log_is_missing(const std::filesystem::path& file);

}  // namespace prosector
