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

/// Returns the folder of what people chose: ${XDG_CONFIG_HOME:-~/.config}/prosector.
std::filesystem::path default_config_dir();

/// Returns the folder of scenes that come with the program in `programs`: of an installed one, else of the
/// checkout that it was built in; empty: there is none.
std::filesystem::path shipped_scenes_dir(const std::filesystem::path& programs);

}  // namespace prosector
