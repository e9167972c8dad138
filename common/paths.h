#pragma once
// Default directories (XDG base directories).

#include <filesystem>

namespace prosector {

/// Returns the directory in which meshes and equilibria are cached, in files named by content hash:
/// ${XDG_CACHE_HOME:-~/.cache}/prosector. It may be deleted at any time.
std::filesystem::path default_cache_dir();

/// Returns the directory of volumes and surfaces that scenes refer to:
/// ${PROSECTOR_DATA:-${XDG_DATA_HOME:-~/.local/share}/prosector}. The set-up fills it.
std::filesystem::path default_data_dir();

/// Returns the directory of user settings: ${XDG_CONFIG_HOME:-~/.config}/prosector.
std::filesystem::path default_config_dir();

/// Returns the directory of the scenes that are shipped with the executables in the directory `programs`.
/// That is the installed one, or else that of the source checkout. Empty if there is none.
std::filesystem::path shipped_scenes_dir(const std::filesystem::path& programs);

}  // namespace prosector
