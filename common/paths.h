#pragma once
// Where Prosector keeps things on this machine when nobody says otherwise (XDG base directories).

#include <filesystem>

namespace prosector {

/// Returns the folder of meshes and equilibria by content hash, which may be deleted at any time:
/// ${XDG_CACHE_HOME:-~/.cache}/prosector.
std::filesystem::path default_cache_dir();

/// Returns the folder of volumes and surfaces that scenes name, put there by the set-up:
/// ${PROSECTOR_DATA:-${XDG_DATA_HOME:-~/.local/share}/prosector}.
std::filesystem::path default_data_dir();

}  // namespace prosector
