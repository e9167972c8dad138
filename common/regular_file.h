#pragma once
// Files that people name, read whole: what would wait for ever or never end is refused first.

#include <cstddef>
#include <filesystem>
#include <string>

namespace prosector {

/// Reads all bytes of `file`. Throws InputError that names the file when it can't be opened, is a folder, a
/// pipe, a device or a socket, or holds more than `max_bytes`. Never waits for a writer.
std::string read_regular_file(const std::filesystem::path& file, std::size_t max_bytes);

/// Throws InputError that names the file and its kind where it exists but is no regular file: a folder, a
/// pipe, a device or a socket.
void refuse_special_file(const std::filesystem::path& file);

}  // namespace prosector
