#pragma once
// Reading of whole files, with gzip decompression.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace prosector {

/// Returns all bytes of the file. Throws InputError if it can't be read or is larger than `max_bytes`.
std::vector<std::uint8_t> read_file(const std::filesystem::path& file,
                                    std::size_t max_bytes = std::size_t{1} << 31);

bool is_gzip(std::span<const std::uint8_t> bytes);

/// Decompresses gzip data and returns at most `max_bytes` bytes. Several concatenated gzip members are
/// decompressed one after another. Bytes that aren't gzip are returned unchanged. Throws InputError naming
/// `name` if the stream is corrupt; a truncated stream yields the data up to its end.
std::vector<std::uint8_t> gunzip(std::span<const std::uint8_t> bytes, std::size_t max_bytes,
                                 const std::string& name);

}  // namespace prosector
