#pragma once
// Files with an integrity check: payload, key, and a hash over both. Used for caches.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

/// Result of reading a file with an integrity check: its bytes, or none and the reason ("" if no file
/// exists).
struct SealedFileResult {
  std::optional<std::vector<std::uint8_t>> bytes;
  std::string error;
};

/// Reads a file that write_sealed_file() wrote with the same key, and verifies its hash. Returns no bytes if
/// any bit of file or key differs.
SealedFileResult read_sealed_file(const std::filesystem::path& file, const std::string& key);

/// Writes the bytes, with the key and a hash over both, to `file`. Writes to a temporary file and renames it,
/// so that readers never see a partial file. Creates the directory. Returns false if the file can't be
/// written.
bool write_sealed_file(const std::filesystem::path& file, const std::string& key,
                       std::span<const std::uint8_t> bytes);

}  // namespace prosector
