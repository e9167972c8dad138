#pragma once
// The one table of all keys of the client's configuration. Reading, errors, writing and the page of
// documentation come from it.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "drivers/client_config.h"

namespace prosector {

inline constexpr int client_config_version = 2;

/// A key's value, as a file has it: in the file's units.
using ConfigValue = std::variant<bool, double, std::string, std::vector<double>>;

enum class ConfigType : std::uint8_t { flag, number, whole, numbers, text };

/// One key.
struct ConfigKey {
  std::string name;  // dotted
  ConfigType type = ConfigType::text;
  double least = 0, most = 0;        // of numbers
  std::size_t count = 0;             // of `numbers`
  std::vector<std::string> choices;  // of a text; empty: any
  std::string needed;                // not empty: must be there where its table is; what it may look like
  std::string unit, help;
  std::string member;                                                  // what it sets
  std::function<void(ClientConfig&, const ConfigValue&)> set;          // may throw InputError: what is wrong
  std::function<std::optional<ConfigValue>(const ClientConfig&)> get;  // nothing: isn't set
};

/// What a rule found: which key, and what must be so.
struct ConfigFault {
  std::string key;
  std::string what;
};

/// One table of the file.
struct ConfigTable {
  std::string name;  // dotted; empty: the top of the file
  std::string help;
  std::function<void(ClientConfig&)> begin;  // before its keys are read; may be empty
  bool whole = false;  // where it is, the defaults of keys that it doesn't name don't hold
  std::function<std::optional<ConfigFault>(ClientConfig&)> finish;  // after all keys; may be empty
};

/// Returns all keys, those of one table together, in the order in which they are read.
std::span<const ConfigKey> client_config_keys();
std::span<const ConfigTable> client_config_tables();
/// Returns the key of that name, or nullptr.
const ConfigKey* find_config_key(std::string_view name);

/// Returns what a key's value must be: "must be a number from 0 to 1".
std::string allowed_values(const ConfigKey& key);
/// Tells whether the value is of the key's type and in its range.
bool fits(const ConfigKey& key, const ConfigValue& value);
/// Returns a value as TOML.
std::string to_toml(const ConfigValue& value);

/// Returns the page docs/look-up/client-configuration.md.
std::string client_config_page();

}  // namespace prosector
