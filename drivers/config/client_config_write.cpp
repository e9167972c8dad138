#include "drivers/config/client_config_write.h"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "common/error.h"
#include "common/regular_file.h"
#include "drivers/files/toml_text.h"

namespace prosector {
namespace {

/// A key that was renamed and whose unit changed in a version.
struct RenamedKey {
  int version;
  const char* from;
  const char* to;  // last part of the new name
  double scale;    // old unit in the new unit
  const char* note;
};
constexpr std::array<RenamedKey, 1> renamed_keys = {
    {{2, "tracker.alignment", "alignment_frame", 0.01,
      "the key tracker.alignment, in cm, is now tracker.alignment_frame, in m"}}};

/// Scales an array of numbers. Any other value is returned unchanged; the reader rejects it.
std::string scaled(const std::string& value, double scale) {
  const toml::table table = toml::parse("v = " + value);
  const toml::array* array = table["v"].as_array();
  if (array == nullptr) return value;
  std::vector<double> out;
  for (const toml::node& item : *array) {
    const auto v = item.is_number() ? item.value<double>() : std::nullopt;
    if (!v || !std::isfinite(*v)) return value;
    out.push_back(*v * scale);
  }
  std::string text = to_toml(out);
  // Keeps the number of lines, so that the following lines do not move.
  const auto lines = std::count(value.begin(), value.end(), '\n');
  return text.insert(text.size() - 1, static_cast<std::size_t>(lines), '\n');
}

int version_of(const TomlEditor& text) {
  const auto value = text.value({"version"});
  return value ? std::atoi(value->c_str()) : 1;
}

/// Migrates the text to the current version and updates its `version` key.
void renew(std::string& text) {
  const MigratedConfig migrated = migrate_client_config(text);
  if (migrated.notes.empty()) return;
  TomlEditor edited(migrated.text);
  edited.set({"version"}, fmt::format("{}", client_config_version));
  text = edited.text();
}

/// Returns the changes, preceded by the defaults that would be lost because a change creates their table.
std::vector<ConfigChange> with_defaults(const TomlEditor& text, const std::vector<ConfigChange>& changes) {
  std::vector<ConfigChange> out;
  const auto is_changed = [&](const std::string& key, const ConfigValue& value) {
    return std::any_of(changes.begin(), changes.end(), [&](const ConfigChange& c) {
      const bool same_station = c.key.ends_with(".station") && key.ends_with(".station") && c.value == value;
      return c.key == key || same_station;
    });
  };
  for (const ConfigTable& table : client_config_tables()) {
    const std::string below = table.name + ".";
    const bool made = table.whole && !text.has_table(split_toml_path(table.name)) &&
                      std::any_of(changes.begin(), changes.end(),
                                  [&](const ConfigChange& c) { return c.key.starts_with(below); });
    if (!made) continue;
    ClientConfig without;
    table.begin(without);
    for (const ConfigKey& key : client_config_keys()) {
      if (!key.name.starts_with(below) || key.type == ConfigType::numbers) continue;
      const auto value = key.get(ClientConfig());
      if (value && value != key.get(without) && !is_changed(key.name, *value))
        out.push_back({key.name, *value});
    }
  }
  out.insert(out.end(), changes.begin(), changes.end());
  return out;
}

}  // namespace

MigratedConfig migrate_client_config(std::string text) {
  TomlEditor edited(std::move(text));
  std::vector<std::string> notes;
  const int version = version_of(edited);
  for (const RenamedKey& row : renamed_keys) {
    const TomlPath path = split_toml_path(row.from);
    const auto value = edited.value(path);
    if (version >= row.version || !value) continue;
    edited.set(path, scaled(*value, row.scale));
    edited.rename(path, row.to);
    notes.emplace_back(row.note);
  }
  return {edited.text(), notes};
}

std::string write_client_config(const std::string& text, const std::vector<ConfigChange>& changes,
                                const std::string& file) {
  (void)parse_client_config(text, file);
  std::string out = text;
  renew(out);
  TomlEditor edited(out);
  for (const ConfigChange& change : with_defaults(edited, changes)) {
    const ConfigKey* key = find_config_key(change.key);
    if (key == nullptr) throw InputError(fmt::format("{}: {}: no such key", file, change.key));
    if (!fits(*key, change.value))
      throw InputError(fmt::format("{}: {}: {}", file, change.key, allowed_values(*key)));
    edited.set(split_toml_path(change.key), to_toml(change.value));
  }
  (void)parse_client_config(edited.text(), file);
  return edited.text();
}

ConfigChange parse_config_change(const std::string& name, const std::string& value) {
  const ConfigKey* key = find_config_key(name);
  if (key == nullptr) throw InputError(fmt::format("{}: no such key", name));
  ConfigChange change{name, value};
  try {
    const toml::table table = toml::parse("v = " + value);
    const toml::node* node = table.get("v");
    if (const auto* text = node->as_string()) {
      change.value = text->get();
    } else if (const auto* flag = node->as_boolean()) {
      change.value = flag->get();
    } else if (node->is_number()) {
      change.value = *node->value<double>();
    } else if (const toml::array* array = node->as_array()) {
      std::vector<double> numbers;
      for (const toml::node& item : *array) numbers.push_back(item.value<double>().value_or(NAN));
      change.value = numbers;
    }
  } catch (const toml::parse_error&) {
    // A text without quotes.
  }
  if (!fits(*key, change.value)) throw InputError(fmt::format("{}: {}", name, allowed_values(*key)));
  return change;
}

std::string read_config_text(const std::filesystem::path& file) {
  constexpr std::size_t max_bytes = 1 << 20;
  return read_regular_file(file, max_bytes);
}

void save_config_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::path aside = file;
  aside += ".new";
  std::ofstream out(aside, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(aside, file, error);
  if (!out || error) throw InputError(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace prosector
