#pragma once
// Whether the write-ahead log beside a SQLite file is there and whole. SQLite itself takes a log up to its
// first damaged frame for all that there is, and says nothing of what follows.

#include <filesystem>

namespace prosector {

/// Tells whether commits lie beyond the part of the log that its checksums prove. A crash leaves none there.
bool log_is_damaged(const std::filesystem::path& log);

/// Tells whether `file` is written with a log beside it, and none is there: it was copied without. Not for a
/// process that has the file open itself: to close it here would end that process's locks.
bool log_is_missing(const std::filesystem::path& file);

}  // namespace prosector
