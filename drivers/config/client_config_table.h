#pragma once
// Table of all keys of the client's configuration. Parsing, error messages, writing and the documentation
// page are derived from it.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "drivers/config/client_config.h"

namespace prosector {

inline constexpr int client_config_version = 2;

/// Value of a key of the client's configuration file, in the units of the file.
using ConfigValue = std::variant<bool, double, std::string, std::vector<double>>;

enum class ConfigType : std::uint8_t { flag, number, whole, numbers, text };

/// One key of the client's configuration file: its name, type, allowed values, help text, and functions that
/// set and get its value in a ClientConfig.
struct ConfigKey {
  std::string name;  // dotted
  ConfigType type = ConfigType::text;
  double least = 0, most = 0;             // range of numbers
  std::size_t count = 0;                  // array size, for `numbers`
  std::vector<std::string> choices = {};  // allowed values of a text; empty: any
  std::string needed = {};                // not empty: required if its table is present; an example value
  std::string unit = {}, help = {};
  std::function<void(ClientConfig&, const ConfigValue&)> set = {};  // may throw InputError with the reason
  std::function<std::optional<ConfigValue>(const ClientConfig&)> get = {};  // nothing: not set
};

/// Fault of a configuration with an invalid combination of values: the key to change and the requirement that
/// it violates.
struct ConfigFault {
  std::string key;
  std::string what;
};

/// One TOML table of the client's configuration file: its name, help text, and the functions called before
/// and after its keys are read.
struct ConfigTable {
  std::string name;  // dotted; empty: top level of the file
  std::string help;
  std::function<void(ClientConfig&)> begin;  // called before the table's keys are read; may be empty
  bool whole = false;  // if the table is present, keys that it omits lose their defaults
  std::function<std::optional<ConfigFault>(ClientConfig&)> finish;  // called after all keys are read; may be
                                                                    // empty
};

/// Returns all keys of the client's configuration file, grouped by table, in the order of the documentation.
std::span<const ConfigKey> client_config_keys();
std::span<const ConfigTable> client_config_tables();
/// Returns the configuration key with this dotted name, such as "tracker.address", or nullptr if there is
/// none.
const ConfigKey* find_config_key(std::string_view name);

/// Returns the requirement for a key's value as a phrase for error messages, such as "must be a number from 0
/// to 1".
std::string allowed_values(const ConfigKey& key);
/// Returns whether the value has the configuration key's type and is in its range or among its choices.
bool fits(const ConfigKey& key, const ConfigValue& value);
/// Formats a configuration value as TOML text, such as `[0, 0.17, 0]`.
std::string to_toml(const ConfigValue& value);

/// Generates the text of the documentation page docs/look-up/client-configuration.md from the table of keys.
std::string client_config_page();

}  // namespace prosector
