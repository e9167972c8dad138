#include "drivers/files/toml_fields.h"

#include <fmt/format.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <cmath>
#include <set>

#include "common/error.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"

namespace prosector {
namespace {

constexpr std::size_t most_bytes = 1 << 20;
constexpr double most_stretch = 0.01;  // tolerance of a quaternion's norm

}  // namespace

/// The parsed file.
struct TomlFields::Text {
  toml::table root;
  std::filesystem::path file;
  std::string kind;
};

/// One table of the file and the keys requested from it.
struct TomlFields::Table {
  std::shared_ptr<const Text> text;
  const toml::table* table;
  mutable std::set<std::string, std::less<>> asked = {};
};

TomlFields TomlFields::parse(const std::string& toml, const std::filesystem::path& file,
                             const std::string& kind) {
  check_nesting(toml, file.string());
  try {
    const auto text = std::make_shared<const Text>(Text{toml::parse(toml, file.string()), file, kind});
    return TomlFields(std::make_shared<const Table>(Table{text, &text->root}));
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
  }
}

TomlFields TomlFields::load(const std::filesystem::path& file, const std::string& kind) {
  return parse(read_regular_file(file, most_bytes), file, kind);
}

void TomlFields::fail(std::string_view key, const std::string& what) const {
  const toml::node* node = table_->table->get(key);
  const auto line = (node == nullptr ? table_->table->source() : node->source()).begin.line;
  throw InputError(fmt::format("{}:{}: {}: {}", table_->text->file.string(), line, key, what));
}

bool TomlFields::has(std::string_view key) const {
  table_->asked.emplace(key);
  return table_->table->contains(key);
}

double TomlFields::number(std::string_view key, double least, double most) const {
  if (!has(key)) fail(key, "is missing");
  const toml::node& node = *table_->table->get(key);
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(*value >= least && *value <= most))
    fail(key, fmt::format("must be a number from {} to {}", least, most));
  return *value;
}

double TomlFields::number(std::string_view key, double least, double most, double otherwise) const {
  return has(key) ? number(key, least, most) : otherwise;
}

int TomlFields::whole(std::string_view key, int least, int most) const {
  const double value = number(key, least, most);
  if (value != std::floor(value)) fail(key, fmt::format("must be a whole number from {} to {}", least, most));
  return static_cast<int>(value);
}

int TomlFields::whole(std::string_view key, int least, int most, int otherwise) const {
  return has(key) ? whole(key, least, most) : otherwise;
}

bool TomlFields::flag(std::string_view key, bool otherwise) const {
  if (!has(key)) return otherwise;
  const auto value = table_->table->get(key)->value_exact<bool>();
  if (!value) fail(key, "must be true or false");
  return *value;
}

std::string TomlFields::text(std::string_view key) const {
  if (!has(key)) fail(key, "is missing");
  const auto value = table_->table->get(key)->value_exact<std::string>();
  if (!value || value->empty()) fail(key, "must be a text");
  return *value;
}

std::string TomlFields::text(std::string_view key, const std::string& otherwise) const {
  return has(key) ? text(key) : otherwise;
}

void TomlFields::numbers(std::string_view key, std::span<double> out, double least, double most) const {
  if (!has(key)) fail(key, "is missing");
  const toml::array* array = table_->table->get(key)->as_array();
  bool good = array != nullptr && array->size() == out.size();
  for (std::size_t i = 0; good && i < out.size(); ++i) {
    const auto value = (*array)[i].is_number() ? (*array)[i].value<double>() : std::nullopt;
    good = value && *value >= least && *value <= most;
    if (good) out[i] = *value;
  }
  if (!good) fail(key, fmt::format("must be {} numbers from {} to {}", out.size(), least, most));
}

Pose TomlFields::pose() const {
  Pose pose;
  if (has("position")) numbers("position", std::span(pose.p.data(), 3), -max_coordinate, max_coordinate);
  if (has("orientation")) {
    std::array<double, 4> q{};
    numbers("orientation", q, -1, 1);
    const Quat read(q[0], q[1], q[2], q[3]);
    if (std::abs(read.norm() - 1) > most_stretch) fail("orientation", "must be a unit quaternion w, x, y, z");
    pose.q = read.normalized();
  }
  return pose;
}

std::filesystem::path TomlFields::file(std::string_view key) const {
  return table_->text->file.parent_path() / text(key);
}

std::vector<TomlFields> TomlFields::tables(std::string_view key) const {
  if (!has(key)) return {};
  std::vector<TomlFields> out;
  const auto add = [&](const toml::table* table) {
    if (table == nullptr) fail(key, "must be a table, or a list of tables");
    out.push_back(TomlFields(std::make_shared<const Table>(Table{table_->text, table})));
  };
  const toml::node& node = *table_->table->get(key);
  if (const toml::array* list = node.as_array())
    for (const toml::node& one : *list) add(one.as_table());
  else
    add(node.as_table());
  return out;
}

void TomlFields::reject_unknown_keys() const {
  for (const auto& [key, node] : *table_->table)
    if (!table_->asked.contains(key.str()))
      fail(key.str(), fmt::format("unknown key of a {}", table_->text->kind));
}

}  // namespace prosector
