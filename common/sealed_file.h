#pragma once
// Files that prove themselves: bytes under a key, with a hash over both. Caches are kept so.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace prosector {

/// What was found at a path: the bytes, or none and why not ("" where there was no file).
struct FoundFile {
  std::optional<std::vector<std::uint8_t>> bytes;
  std::string trouble;
};

/// Reads what write_sealed() wrote under the same key. Whatever bit differs, nothing is returned.
FoundFile read_sealed(const std::filesystem::path& file, const std::string& key);

/// Writes aside and renames, so that readers see all or nothing; makes the folder. Returns false when it
/// can't be written.
bool write_sealed(const std::filesystem::path& file, const std::string& key,
                  std::span<const std::uint8_t> bytes);

}  // namespace prosector
