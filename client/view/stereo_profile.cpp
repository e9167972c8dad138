#include "client/view/stereo_profile.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <vector>

#include "common/embedded_file.h"
#include "common/error.h"
#include "common/regular_file.h"
#include "common/toml_nesting.h"

namespace prosector {

extern const std::span<const EmbeddedFile> shipped_stereo_profiles;

namespace {

struct NumberField {
  std::string_view key;
  double StereoProfile::*in;
  double least, most;
  const char* unit;
  double scale = 1;  // factor from the file's unit to the field's
  bool whole = false;
};

constexpr double degree = std::numbers::pi / 180;

constexpr std::array<NumberField, 6> number_fields = {
    {{"eye_width", &StereoProfile::eye_width, 16, 4096, "pixels", 1, true},
     {"eye_height", &StereoProfile::eye_height, 16, 8192, "pixels", 1, true},
     {"fov_horizontal", &StereoProfile::fov_horizontal, 1, 170, "degrees", degree},
     {"fov_vertical", &StereoProfile::fov_vertical, 1, 170, "degrees", degree},
     {"eye_distance", &StereoProfile::eye_distance, 0, 0.2, "m"},
     {"convergence", &StereoProfile::convergence, 0.05, 1000, "m"}}};

class ProfileReader {
 public:
  ProfileReader(const toml::table& table, const std::string& file) : table_(table), file_(file) {}

  StereoProfile read() const {
    StereoProfile out;
    for (const auto& [key, node] : table_) read_key(key.str(), node, out);
    return out;
  }

 private:
  const toml::table& table_;
  const std::string& file_;

  void read_key(std::string_view key, const toml::node& node, StereoProfile& out) const {
    const auto field = std::find_if(number_fields.begin(), number_fields.end(),
                                    [&](const NumberField& f) { return f.key == key; });
    if (field != number_fields.end()) {
      out.*field->in = number(node, *field);
    } else if (key == "swap_eyes") {
      out.swap_eyes = value<bool>(key, node, "true or false");
    } else if (key == "description") {
      out.description = value<std::string>(key, node, "a string");
    } else {
      std::vector<std::string_view> known = {"description", "swap_eyes"};
      for (const NumberField& f : number_fields) known.push_back(f.key);
      fail(key, node, fmt::format("unknown key; allowed: {}", fmt::join(known, ", ")));
    }
  }

  double number(const toml::node& node, const NumberField& field) const {
    const auto v = node.is_number() ? node.value<double>() : std::nullopt;
    const bool fits =
        v && *v >= field.least && *v <= field.most && (!field.whole || *v == std::floor(*v));  // not NaN
    if (!fits)
      fail(field.key, node,
           fmt::format("must be a {}number from {} to {} {}", field.whole ? "whole " : "", field.least,
                       field.most, field.unit));
    return field.scale * *v;
  }

  template <class T>
  T value(std::string_view key, const toml::node& node, const char* allowed) const {
    const auto v = node.value_exact<T>();
    if (!v) fail(key, node, fmt::format("must be {}", allowed));
    return *v;
  }

  [[noreturn]] void fail(std::string_view key, const toml::node& node, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}: {}", file_, node.source().begin.line, key, what));
  }
};

}  // namespace

std::vector<std::string> shipped_profiles() {
  std::vector<std::string> out;
  for (const EmbeddedFile& file : shipped_stereo_profiles)
    out.push_back(std::filesystem::path(file.name).stem().string());
  return out;
}

StereoProfile parse_stereo_profile(std::string_view toml, const std::string& file) {
  check_nesting(toml, file);
  try {
    return ProfileReader(toml::parse(toml, file), file).read();
  } catch (const toml::parse_error& e) {
    throw InputError(fmt::format("{}:{}: {}", file, e.source().begin.line, e.description()));
  }
}

StereoProfile load_stereo_profile(const std::string& profile) {
  if (!std::filesystem::exists(profile)) {
    const auto shipped = find_embedded(shipped_stereo_profiles, profile + ".toml");
    if (!shipped)
      throw InputError(fmt::format("stereo profile {}: neither a file nor one of the shipped profiles: {}",
                                   profile, fmt::join(shipped_profiles(), ", ")));
    return parse_stereo_profile(*shipped, profile);
  }
  constexpr std::size_t max_bytes = 1 << 20;
  return parse_stereo_profile(read_regular_file(profile, max_bytes), profile);
}

}  // namespace prosector
