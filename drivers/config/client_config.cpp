#include "drivers/config/client_config.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <optional>
#include <set>

#include "common/error.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"
#include "drivers/camera/base/camera_calibration.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/config/client_config_table.h"
#include "drivers/config/client_config_write.h"
#include "drivers/device/field_map.h"

namespace prosector {
namespace {

/// Returns the next part of a dotted name after `table`, up to the next dot; empty if the name is not below
/// `table`.
std::string next_part(const std::string& name, const std::string& table) {
  const std::string prefix = fmt::format("{}{}", table, table.empty() ? "" : ".");
  if (name.size() <= prefix.size() || name.compare(0, prefix.size(), prefix) != 0) return "";
  return name.substr(prefix.size(), name.find('.', prefix.size()) - prefix.size());
}

bool is_config_table(const std::string& name) {
  for (const ConfigTable& table : client_config_tables())
    if (table.name == name) return true;
  return false;
}

/// Reads a parsed file according to the table of keys.
class ConfigReader {
 public:
  ConfigReader(const toml::table& root, const std::string& file) : root_(root), file_(file) {}

  ClientConfig read() {
    check_version();
    refuse_unknown(root_, "");
    for (const ConfigTable& table : client_config_tables())
      if (find(table.name) != nullptr && table.begin) table.begin(config_);
    for (const ConfigTable& table : client_config_tables())
      if (const toml::node* node = find(table.name)) read_keys(*node->as_table(), table.name);
    for (const ConfigTable& table : client_config_tables()) {
      const toml::node* node = find(table.name);
      if (node == nullptr || !table.finish) continue;
      if (const auto fault = table.finish(config_)) {
        const toml::node* at = node->as_table()->get(fault->key);
        fail(at == nullptr ? *node : *at, table.name.empty() ? fault->key : table.name + "." + fault->key,
             fault->what);
      }
    }
    return config_;
  }

 private:
  /// Returns the node of a dotted name; the root for an empty name, nullptr if the node does not exist.
  const toml::node* find(const std::string& name) const {
    return name.empty() ? &static_cast<const toml::node&>(root_) : root_.at_path(name).node();
  }

  /// Throws InputError if the file has a newer version, before unknown keys are reported.
  void check_version() const {
    const toml::node* node = find("version");
    const auto v = node != nullptr && node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (v && *v > client_config_version)
      fail(*node, "version",
           fmt::format(
               "a file of version {} was written by a newer Prosector; this program reads versions up to {}",
               *v, client_config_version));
  }

  void refuse_unknown(const toml::table& table, const std::string& name) const {
    std::set<std::string> known;
    for (const ConfigKey& key : client_config_keys())
      if (std::string part = next_part(key.name, name); !part.empty()) known.insert(std::move(part));
    for (const auto& [key, node] : table) {
      const std::string child = fmt::format("{}{}{}", name, name.empty() ? "" : ".", key.str());
      if (!known.contains(std::string(key.str())))
        fail(node, child, fmt::format("unknown key; allowed here: {}", fmt::join(known, ", ")));
      if (!is_config_table(child)) continue;
      if (!node.is_table()) fail(node, child, "must be a table");
      refuse_unknown(*node.as_table(), child);
    }
  }

  void read_keys(const toml::table& table, const std::string& name) {
    for (const ConfigKey& key : client_config_keys()) {
      const std::string part = next_part(key.name, name);
      if (part.empty() || key.name.size() != part.size() + (name.empty() ? 0 : name.size() + 1)) continue;
      const toml::node* node = table.get(part);
      if (node == nullptr) {
        if (!key.needed.empty())
          fail(table, key.name, fmt::format("must be given; this key is required, e.g. {}", key.needed));
        continue;
      }
      const auto value = to_value(*node, key);
      if (!value || !fits(key, *value)) fail(*node, key.name, allowed_values(key));
      try {
        key.set(config_, *value);
      } catch (const InputError& e) {
        fail(*node, key.name, e.what());
      }
    }
  }

  static std::optional<ConfigValue> to_value(const toml::node& node, const ConfigKey& key) {
    if (const auto* v = node.as_boolean()) return ConfigValue(v->get());
    if (const auto* v = node.as_string()) return ConfigValue(v->get());
    if (node.is_number()) return ConfigValue(*node.value<double>());
    const toml::array* array = node.as_array();
    if (array == nullptr || key.type != ConfigType::numbers) return std::nullopt;
    std::vector<double> out;
    for (const toml::node& item : *array) {
      if (!item.is_number()) return std::nullopt;
      out.push_back(*item.value<double>());
    }
    return out;
  }

  [[noreturn]] void fail(const toml::node& node, const std::string& key, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}: {}", file_, node.source().begin.line, key, what));
  }

  const toml::table& root_;
  const std::string& file_;
  ClientConfig config_;
};

}  // namespace

ClientConfig parse_client_config(std::string_view toml, const std::string& file) {
  check_nesting(toml, file);
  try {
    toml::table table = toml::parse(toml, file);
    const MigratedConfig migrated = migrate_client_config(std::string(toml));
    if (!migrated.notes.empty()) table = toml::parse(migrated.text, file);
    ClientConfig config = ConfigReader(table, file).read();
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    DeviceConfig& tracker = config.tracker_device;
    for (std::string* name : {&tracker.placement.field_map, &tracker.camera.lens, &tracker.hands.second_lens,
                              &config.window.device.camera.lens})
      if (!name->empty()) *name = (folder / *name).string();
    for (std::string& board : tracker.tags.boards)
      if (board.ends_with(".toml")) board = (folder / board).string();
    for (std::string* board : {&tracker.camera.table, &config.phantom.board})
      if (board->ends_with(".toml")) *board = (folder / *board).string();
    if (std::string& mesh = config.phantom.mesh; !mesh.empty()) mesh = (folder / mesh).string();
    return config;
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
  }
}

ClientConfig load_client_config(const std::filesystem::path& file) {
  ClientConfig config = parse_client_config(read_config_text(file), file.string());
  if (const std::string& map = config.tracker_device.placement.field_map; !map.empty())
    (void)load_field_map(map);
  for (const std::string& lens : {config.tracker_device.camera.lens, config.tracker_device.hands.second_lens,
                                  config.window.device.camera.lens})
    if (!lens.empty()) (void)load_calibration(lens);
  for (const std::string& board : config.tracker_device.tags.boards)
    if (!board.empty()) (void)find_board(board);
  for (const std::string& board : {config.tracker_device.camera.table, config.phantom.board})
    if (!board.empty()) (void)find_board(board);
  return config;
}

}  // namespace prosector
