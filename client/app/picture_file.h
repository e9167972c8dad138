#pragma once
// Where pictures go that people keep with a key, and what they are called.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace prosector {

/// Returns the person's folder of pictures, as the desktop has it (XDG), else ~/Pictures, else the current
/// folder. `variable` returns what a variable of the environment is; empty: it is not set.
std::filesystem::path pictures_folder(const std::function<std::string(const char*)>& variable);

/// Returns a name in the folder that no file has: "prosector-2026-11-25-162031-tick-742.png", with a number
/// where that is taken. `now` is told in local time.
std::filesystem::path free_picture_file(const std::filesystem::path& folder,
                                        std::chrono::system_clock::time_point now, std::uint64_t tick);

}  // namespace prosector
