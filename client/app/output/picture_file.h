#pragma once
// Folder and file names of screenshots taken with a key.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace prosector {

/// Returns the folder for screenshots: the user's picture folder according to the desktop (XDG), else
/// ~/Pictures, else the current folder. `variable` is called with the name of an environment variable and
/// returns its value; empty if not set.
std::filesystem::path pictures_folder(const std::function<std::string(const char*)>& variable);

/// Returns an unused file name for a screenshot in the folder: "prosector-2026-11-25-162031-tick-742.png",
/// with a number added if that exists. `now` is written in local time; `tick` is the displayed simulation
/// step.
std::filesystem::path free_picture_file(const std::filesystem::path& folder,
                                        std::chrono::system_clock::time_point now, std::uint64_t tick);

}  // namespace prosector
