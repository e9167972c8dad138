#pragma once
// Edits keys of a user-written configuration file. Comments, order and everything else stay unchanged, byte
// for byte.

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/config/client_config_table.h"

namespace prosector {

/// Change of one key in the client's configuration file: the key's dotted name, such as "tracker.address",
/// and its new value, in the file's units.
struct ConfigChange {
  std::string key;  // dotted
  ConfigValue value;
};

/// Text of a configuration file after migration to the current version, with one note for each change made.
struct MigratedConfig {
  std::string text;
  std::vector<std::string> notes;
};

/// Replaces keys of older versions in a client configuration's text with those of the current version. Each
/// key stays on its line. The text must be valid TOML.
MigratedConfig migrate_client_config(std::string text);

/// Applies the changes to a client configuration's text, migrates older keys to the current version, and
/// returns the new text. Keys without a change keep their meaning. If a change creates a table whose presence
/// removes defaults, these defaults are written explicitly. Throws InputError if the text, a key, a value or
/// the result is invalid; `file` is used in messages.
std::string write_client_config(const std::string& text, const std::vector<ConfigChange>& changes,
                                const std::string& file);

/// Parses a configuration key's value given on the command line, such as true, 0.5, "text" or [1, 2, 3].
/// Quotes around a text are optional. Throws InputError with the allowed values.
ConfigChange parse_config_change(const std::string& key, const std::string& value);

/// Reads a client configuration file as text. Throws InputError if it is unreadable.
std::string read_config_text(const std::filesystem::path& file);
/// Replaces a client configuration file atomically: writes a temporary file and renames it. Throws InputError
/// on failure.
void save_config_text(const std::filesystem::path& file, const std::string& text);

}  // namespace prosector
