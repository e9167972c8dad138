#pragma once
// Changes keys of a configuration that people wrote: comments, order and all else stay, byte for byte.

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/client_config_table.h"

namespace prosector {

/// A key that gets a value, in the file's units.
struct ConfigChange {
  std::string key;  // dotted
  ConfigValue value;
};

/// A text of the present version, and what was changed for that, in words.
struct MigratedConfig {
  std::string text;
  std::vector<std::string> notes;
};

/// Brings the keys of an older version to the present one. Each stays on its line. The text must be TOML.
MigratedConfig migrate_client_config(std::string text);

/// Returns the text with the changes, its older keys brought to the present version. What no change names
/// means what it meant before: where a change makes a table whose defaults hold only without it, these are
/// written out. Throws InputError where the text, a key or a value is not allowed, or what comes out isn't;
/// `file` is for messages.
std::string write_client_config(const std::string& text, const std::vector<ConfigChange>& changes,
                                const std::string& file);

/// Reads a key's value as people give it: true, 0.5, "text", [1, 2, 3]; a text may stand without quotes.
/// Throws InputError with what is allowed.
ConfigChange parse_config_change(const std::string& key, const std::string& value);

/// Reads the text of a configuration file. Throws InputError.
std::string read_config_text(const std::filesystem::path& file);
/// Writes it aside and renames, so that a reader sees all or nothing. Throws InputError where it can't.
void save_config_text(const std::filesystem::path& file, const std::string& text);

}  // namespace prosector
