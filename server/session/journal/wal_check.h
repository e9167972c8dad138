#pragma once
// Checks whether the write-ahead log of a SQLite file exists and is complete. SQLite itself reads a log up to
// its first damaged frame, and silently ignores the rest.

#include <filesystem>

namespace prosector {

/// Returns whether the SQLite write-ahead log `log` has commits after the part that its checksums verify. A
/// crash leaves no such commits, so the log is damaged.
bool log_is_damaged(const std::filesystem::path& log);

/// Returns whether the SQLite file uses a write-ahead log and none exists, because the file was copied
/// without it. Must not be called by a process that has the file open: closing it here would release that
/// process's locks.
bool log_is_missing(const std::filesystem::path& file);

}  // namespace prosector
