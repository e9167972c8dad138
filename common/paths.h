#pragma once
// Default directories (XDG base directories).

#include <filesystem>

namespace prosector {

/// Returns the cache directory of meshes and equilibria, named by content hash:
/// ${XDG_CACHE_HOME:-~/.cache}/prosector. It may be deleted at any time.
std::filesystem::path default_cache_dir();

/// Returns the directory of volumes and surfaces that scenes refer to, filled by the set-up:
/// ${PROSECTOR_DATA:-${XDG_DATA_HOME:-~/.local/share}/prosector}.
std::filesystem::path default_data_dir();

/// Returns the directory of user settings: ${XDG_CONFIG_HOME:-~/.config}/prosector.
std::filesystem::path default_config_dir();

/// Returns the directory of scenes shipped with the executables in `programs`: the installed one, else that
/// of the source checkout. Empty if there is none.
std::filesystem::path shipped_scenes_dir(const std::filesystem::path& programs);

}  // namespace prosector
