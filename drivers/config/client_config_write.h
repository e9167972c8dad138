#pragma once
// Edits keys of a user-written configuration file. Comments, order and everything else stay unchanged, byte
// for byte.

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/config/client_config_table.h"

namespace prosector {

/// New value of a key, in the file's units.
struct ConfigChange {
  std::string key;  // dotted
  ConfigValue value;
};

/// Text migrated to the current version, and a description of each change.
struct MigratedConfig {
  std::string text;
  std::vector<std::string> notes;
};

/// Migrates the keys of an older version to the current one. Each key stays on its line. The text must be
/// valid TOML.
MigratedConfig migrate_client_config(std::string text);

/// Applies the changes and migrates older keys to the current version. Keys without a change keep their
/// meaning. If a change creates a table whose presence removes defaults, these defaults are written
/// explicitly. Throws InputError if the text, a key, a value or the result is invalid; `file` is used in
/// messages.
std::string write_client_config(const std::string& text, const std::vector<ConfigChange>& changes,
                                const std::string& file);

/// Parses a key's value from the command line: true, 0.5, "text", [1, 2, 3]. Quotes around a text are
/// optional. Throws InputError with the allowed values.
ConfigChange parse_config_change(const std::string& key, const std::string& value);

/// Reads a configuration file as text. Throws InputError.
std::string read_config_text(const std::filesystem::path& file);
/// Writes a temporary file and renames it, so that the replacement is atomic. Throws InputError on failure.
void save_config_text(const std::filesystem::path& file, const std::string& text);

}  // namespace prosector
