#include "common/paths.h"

#include <cstdlib>

namespace prosector {
namespace {

namespace fs = std::filesystem;

/// Returns an environment variable as a path; empty if unset or empty.
fs::path from_environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? fs::path() : fs::path(value);
}

/// Returns $variable, else ~/`below_home`. XDG: a relative path in the variable is invalid and ignored.
/// Without a home directory, returns the system's temporary directory.
fs::path xdg(const char* variable, const char* below_home) {
  if (const fs::path set = from_environment(variable); set.is_absolute()) return set;
  if (const fs::path home = from_environment("HOME"); !home.empty()) return home / below_home;
  return fs::temp_directory_path();
}

}  // namespace

fs::path default_cache_dir() {
  return xdg("XDG_CACHE_HOME", ".cache") / "prosector";
}

fs::path default_data_dir() {
  if (const fs::path set = from_environment("PROSECTOR_DATA"); !set.empty()) return set;
  return xdg("XDG_DATA_HOME", ".local/share") / "prosector";
}

fs::path default_config_dir() {
  return xdg("XDG_CONFIG_HOME", ".config") / "prosector";
}

fs::path shipped_scenes_dir(const fs::path& programs) {
  for (const char* beside : {"../share/prosector/scenes", "../../../deploy/scenes"}) {
    std::error_code error;
    if (const fs::path found = fs::weakly_canonical(programs / beside, error); fs::is_directory(found, error))
      return found;
  }
  return {};
}

}  // namespace prosector
