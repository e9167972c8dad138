#pragma once
// Reading of whole user-specified files. Special files, which may block or never end, are refused first.

#include <cstddef>
#include <filesystem>
#include <string>

namespace prosector {

/// Returns all bytes of `file`. Throws InputError that names the file if it can't be opened, is a directory,
/// pipe, device or socket, or exceeds `max_bytes`. Never waits for a writer.
std::string read_regular_file(const std::filesystem::path& file, std::size_t max_bytes);

/// Checks that a path does not refer to a special file. Throws InputError that names the file and its kind if
/// it exists but is a directory, pipe, device or socket.
void require_regular_file(const std::filesystem::path& file);

}  // namespace prosector
