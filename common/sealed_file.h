#pragma once
// Files with an integrity check: payload, key, and a hash over both. Used for caches.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

/// Result of reading a sealed file: its bytes, or none and the reason ("" if no file exists).
struct SealedFileResult {
  std::optional<std::vector<std::uint8_t>> bytes;
  std::string trouble;
};

/// Reads a file written by write_sealed_file() with the same key. Returns no bytes if any bit differs.
SealedFileResult read_sealed_file(const std::filesystem::path& file, const std::string& key);

/// Writes to a temporary file and renames it, so that readers never see a partial file. Creates the
/// directory. Returns false if the file can't be written.
bool write_sealed_file(const std::filesystem::path& file, const std::string& key,
                       std::span<const std::uint8_t> bytes);

}  // namespace prosector
