#pragma once
// Whether the write-ahead log beside a SQLite file is whole. SQLite itself takes a log up to its first
// damaged frame for all that there is, and says nothing of what follows.

#include <filesystem>

namespace prosector {

/// True when commits lie beyond the part of the log that its checksums prove. A crash leaves none there.
bool log_is_damaged(const std::filesystem::path& log);

}  // namespace prosector
