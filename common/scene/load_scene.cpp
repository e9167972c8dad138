// Scene loader: walks a TOML document along the field tables. The only file that uses toml++.

#include "common/scene/load_scene.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>

#include "common/error.h"
#include "common/regular_file.h"
#include "common/scene/scene_checks.h"
#include "common/scene/scene_fields.h"
#include "common/scene/suggest.h"
#include "common/toml_nesting.h"

namespace prosector {
namespace {

constexpr std::size_t max_scene_bytes = 4u * 1024 * 1024;

int line_of(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

/// Returns a value for messages: as it was written, truncated.
std::string written(const toml::node& node) {
  std::ostringstream out;
  node.visit([&](const auto& n) { out << n; });
  std::string s = out.str();
  if (s.size() > 60) s = s.substr(0, 57) + "...";
  return s;
}

class Reader {
 public:
  Reader(const std::filesystem::path& file, SourceLines& lines) : file_(file), lines_(lines) {}

  /// Reads `source` into the struct `object` that `table` describes. `path` identifies it in SourceLines.
  void read(const toml::table& source, const Table& table, void* object, const std::string& path,
            const std::string& where) {
    lines_.set(path, line_of(source));
    refuse_unknown_keys(source, table, where);
    for (const Field& field : table.fields) {
      const toml::node* node = source.get(field.key);
      if (node == nullptr) {
        if (field.required) fail(line_of(source), where, fmt::format("{} is missing", field.key));
        continue;
      }
      lines_.set(join(path, field.key), line_of(*node));
      read_field(*node, field, field.in(object), where);
    }
    for (const Child& child : table.children)
      if (const toml::node* node = source.get(child.key)) read_child(*node, child, object, path, where);
  }

  [[noreturn]] void fail(int line, const std::string& where, const std::string& what) const {
    throw InputError(
        fmt::format("{}:{}: {}{}{}", file_.string(), line, where, where.empty() ? "" : ": ", what));
  }

 private:
  static std::string join(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
  }

  void refuse_unknown_keys(const toml::table& source, const Table& table, const std::string& where) const {
    std::vector<std::string_view> known;
    for (const Field& f : table.fields) known.push_back(f.key);
    for (const Child& c : table.children) known.push_back(c.key);
    for (const auto& [key, node] : source) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      fail(static_cast<int>(key.source().begin.line), where,
           fmt::format("unknown key \"{}\"{}", key.str(), suggest(key.str(), known)));
    }
  }

  void read_child(const toml::node& node, const Child& child, void* object, const std::string& path,
                  const std::string& where) {
    const Table& table = child.table();
    if (!child.repeated) {
      const toml::table* source = node.as_table();
      if (source == nullptr) fail(line_of(node), where, fmt::format("{} must be a table", table.name));
      read(*source, table, child.items.add(object), join(path, child.key), std::string(table.name));
      return;
    }
    const toml::array* list = node.as_array();
    if (list == nullptr ||
        !std::all_of(list->begin(), list->end(), [](const auto& n) { return n.is_table(); }))
      fail(line_of(node), where,
           fmt::format("{} must be a list of tables, each headed {}", child.key, table.name));
    if (list->size() > child.max_count)
      fail(line_of((*list)[child.max_count]), where,
           fmt::format("{} {}: at most {} are allowed", list->size(), table.name, child.max_count));
    for (std::size_t i = 0; i < list->size(); ++i) {
      const toml::table& source = *(*list)[i].as_table();
      read(source, table, child.items.add(object), fmt::format("{}[{}]", join(path, child.key), i),
           describe(source, table, i, where));
    }
  }

  /// Returns `[[soft]] "liver"`, or `[[light]] 2` if there is no name.
  static std::string describe(const toml::table& source, const Table& table, std::size_t i,
                              const std::string& parent) {
    const std::string own = source["name"].is_string()
                                ? fmt::format("{} \"{}\"", table.name, *source["name"].value<std::string>())
                                : fmt::format("{} {}", table.name, i + 1);
    return parent.empty() ? own : fmt::format("{}: {}", parent, own);
  }

  void read_field(const toml::node& node, const Field& field, const FieldRef& ref,
                  const std::string& where) const {
    if (!std::visit([&](auto* value) { return store(node, field, *value); }, ref))
      fail(line_of(node), where,
           fmt::format("{} = {}{}: must be {}", field.key, written(node), unit_of(node, field),
                       allowed(field, ref)));
  }

  /// Returns the field's unit for messages; empty for text, which contains its own unit or lacks one.
  static std::string unit_of(const toml::node& node, const Field& field) {
    return field.unit.empty() || node.is_string() ? "" : fmt::format(" {}", field.unit);
  }

  // ---- One `store` per type; it returns false if the field does not allow the value.

  static bool store(const toml::node& node, const Field& field, double& out) {
    if (!node.is_number()) return false;
    out = *node.value<double>();
    return std::isfinite(out) && field.range.contains(out);
  }

  static bool store(const toml::node& node, const Field& field, int& out) {
    if (!node.is_integer()) return false;
    const auto n = *node.value<std::int64_t>();
    if (!field.range.contains(static_cast<double>(n))) return false;
    out = static_cast<int>(n);
    return true;
  }

  static bool store(const toml::node& node, const Field&, bool& out) {
    if (!node.is_boolean()) return false;
    out = *node.value<bool>();
    return true;
  }

  static bool store(const toml::node& node, const Field& field, std::string& out) {
    if (!node.is_string()) return false;
    out = *node.value<std::string>();
    if (!field.words.empty())
      return std::find(field.words.begin(), field.words.end(), out) != field.words.end();
    if (out.size() > field.max_length || out.find('\0') != std::string::npos) return false;
    switch (field.text) {
      case Text::free:
        return true;
      case Text::name:
        return !out.empty() && std::none_of(out.begin(), out.end(), [](char c) {
          return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
        });
      case Text::identifier:
        return !out.empty() && out[0] >= 'a' && out[0] <= 'z' &&
               std::all_of(out.begin(), out.end(), [](char c) {
                 return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
               });
    }
    return false;
  }

  static bool store(const toml::node& node, const Field& field, std::vector<std::string>& out) {
    const toml::array* list = node.as_array();
    if (list == nullptr) return false;
    out.clear();  // removes the default entries
    for (const toml::node& name : *list)
      if (!store(name, field, out.emplace_back())) return false;
    return true;
  }

  /// Stores a list of numbers, or of [x, y, z].
  template <class T>
  static bool store(const toml::node& node, const Field& field, std::vector<T>& out) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() > field.max_length) return false;
    out.clear();
    for (const toml::node& entry : *list)
      if (!store(entry, field, out.emplace_back())) return false;
    return true;
  }

  /// Parses a number, optional spaces, and the field's unit: "2 %", "0.5ms".
  static bool store(const toml::node& node, const Field& field, Quantity& out) {
    if (!node.is_string()) return false;
    const std::string text = *node.value<std::string>();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
    if (error != std::errc()) return false;
    std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    return rest == field.unit && std::isfinite(out.value) && field.range.contains(out.value);
  }

  static bool store(const toml::node& node, const Field& field, std::uint8_t& out) {
    if (!node.is_string()) return false;
    const auto word = std::find(field.words.begin(), field.words.end(), *node.value<std::string>());
    if (word == field.words.end()) return false;
    out = static_cast<std::uint8_t>(word - field.words.begin());
    return true;
  }

  /// Stores `count` finite numbers.
  static bool numbers(const toml::node& node, double* out, std::size_t count) {
    const toml::array* list = node.as_array();
    if (list == nullptr || list->size() != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (!(*list)[i].is_number()) return false;
      out[i] = *(*list)[i].value<double>();
      if (!std::isfinite(out[i])) return false;
    }
    return true;
  }

  static bool store(const toml::node& node, const Field& field, Vec3& out) {
    if (!numbers(node, out.data(), 3)) return false;
    return std::all_of(out.data(), out.data() + 3, [&](double x) { return field.range.contains(x); });
  }

  static bool store(const toml::node& node, const Field&, Quat& out) {
    double wxyz[4];
    if (!numbers(node, wxyz, 4)) return false;
    Quat q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    const double largest = q.coeffs().cwiseAbs().maxCoeff();
    if (largest < 1e-6) return false;
    q.coeffs() /= largest;  // avoids overflow and underflow of the squares
    out = q.normalized();
    return true;
  }

  const std::filesystem::path& file_;
  SourceLines& lines_;
};

}  // namespace

SceneDesc parse_scene(std::string_view toml, const std::filesystem::path& file) {
  check_nesting(toml, file.string());
  toml::table document;
  try {
    document = toml::parse(toml, file.string());
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
  }
  SceneDesc scene;
  scene.room.emplace();
  SourceLines lines;
  Reader reader(file, lines);
  reader.read(document, scene_table(), &scene, "", "");
  scene.file = file;
  set_fixed_choices(scene, lines);
  check_scene(scene, lines);
  return scene;
}

std::string read_scene_text(const std::filesystem::path& file) {
  return read_regular_file(file, max_scene_bytes);
}

SceneDesc load_scene(const std::filesystem::path& file) {
  return parse_scene(read_scene_text(file), file);
}

std::vector<std::string> referenced_files(const SceneDesc& scene) {
  std::set<std::string> out = {scene.labels};
  for (const RigidDesc& body : scene.rigid) out.insert({body.geometry.mesh, body.geometry.volume});
  for (const SoftDesc& body : scene.soft) out.insert({body.geometry.mesh, body.geometry.volume});
  for (const AtlasDesc& atlas : scene.atlases) out.insert({atlas.volume, atlas.labels});
  out.erase("");
  return {out.begin(), out.end()};
}

std::vector<std::string> scene_hints(const SceneDesc& scene) {
  std::vector<std::string> out;
  if (scene.lights.empty())
    out.emplace_back(
        "hint: this scene has no light, so it is rendered dark; add a [[light]], e.g. with kind = "
        "\"directional\" and direction = [0, -1, -0.5]");
  return out;
}

}  // namespace prosector
