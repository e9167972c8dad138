#pragma once
// Whole files as bytes, gzip included.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace prosector {

/// Throws InputError when the file can't be read or is larger than `max_bytes`.
std::vector<std::uint8_t> read_file(const std::filesystem::path& file,
                                    std::size_t max_bytes = std::size_t{1} << 31);

bool is_gzip(std::span<const std::uint8_t> bytes);

/// Returns up to `max_bytes` of what the gzip members hold, one after the other (bytes that aren't gzip are
/// returned as they are). Throws InputError naming `name` when the stream is damaged; one that ends early
/// yields what there is.
std::vector<std::uint8_t> gunzip(std::span<const std::uint8_t> bytes, std::size_t max_bytes,
                                 const std::string& name);

}  // namespace prosector
