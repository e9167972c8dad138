#include "client/app/run/option_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <map>

#include "common/error.h"
#include "common/local_name.h"

namespace prosector {
namespace {

const std::map<std::string, Display> displays = {
    {"window", Display::window},       {"stereo", Display::stereo}, {"openxr", Display::openxr},
    {"offscreen", Display::offscreen}, {"osmesa", Display::osmesa}, {"none", Display::none}};

/// Returns the language of messages from the environment variables, in the order that POSIX defines.
std::string locale_language() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const char* value = std::getenv(variable); value != nullptr && *value != '\0')
      return language_of_locale(value);
  return "";
}

void parse_effect(const std::string& text, EffectSet& effects) {
  const auto equals = text.find('=');
  const std::string name = text.substr(0, equals);
  const std::string state = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto row = std::find_if(effect_rows.begin(), effect_rows.end(),
                                [&](const EffectRow& known) { return known.name == name; });
  if (row == effect_rows.end() || (state != "on" && state != "off"))
    throw InputError(
        fmt::format("--effect {}: must be NAME=on or NAME=off, with NAME {}", text, effect_names(", ")));
  effects[static_cast<std::size_t>(row - effect_rows.begin())] = state == "on";
}

}  // namespace

std::string effect_names(std::string_view between) {
  std::string out;
  for (const EffectRow& row : effect_rows) out += fmt::format("{}{}", out.empty() ? "" : between, row.name);
  return out;
}

void parse_size(const std::string& text, int& width, int& height) {
  const auto x = text.find('x');
  const auto number = [&](std::size_t from, std::size_t to, int& out) {
    const auto [end, error] = std::from_chars(text.data() + from, text.data() + to, out);
    return error == std::errc() && end == text.data() + to && out >= 16 && out <= 8192;
  };
  if (x == std::string::npos || !number(0, x, width) || !number(x + 1, text.size(), height))
    throw InputError(
        fmt::format("--size {}: must be WIDTHxHEIGHT in pixels, each 16 to 8192, e.g. 800x600", text));
}

bool parse_display(const std::string& text, DisplayOptions& o) {
  const auto colon = text.find(':');
  if (text == "ar" || text == "ar:offscreen") {
    o.kind = text == "ar" ? Display::window : Display::offscreen;
    return true;
  }
  const auto found = displays.find(text.substr(0, colon));
  if (found == displays.end() || (colon != std::string::npos && found->second != Display::stereo))
    throw InputError(
        fmt::format("--display {}: must be window, stereo, stereo:PROFILE, openxr, ar, ar:offscreen, "
                    "offscreen, osmesa or none",
                    text));
  o.kind = found->second;
  if (o.kind != Display::stereo) return false;
  if (colon != std::string::npos) o.stereo = load_stereo_profile(text.substr(colon + 1));
  o.width = o.stereo.picture_width();
  o.height = o.stereo.picture_height();
  return false;
}

QualityLevel parse_quality(const RawOptions& raw) {
  for (const QualityLevel& level : quality_levels)
    if (level.name == raw.quality) {
      QualityLevel out = level;
      for (const std::string& effect : raw.effects) parse_effect(effect, out.settings.effects);
      out.detail = raw.detail.value_or(out.detail);
      return out;
    }
  throw InputError(fmt::format("--quality {}: must be low, medium or high", raw.quality));
}

Shown parse_shown(const std::string& text) {
  for (std::size_t k = 0; k < value_scales.size(); ++k)
    if (value_scales[k].name == text) return static_cast<Shown>(k);
  throw InputError(fmt::format("--color-by {}: must be strain, residual, error or none", text));
}

Screenshot parse_screenshot(const std::string& text) {
  const auto at = text.rfind('@');
  if (at == std::string::npos) return {text, std::nullopt};
  double seconds = 0;
  const auto [end, error] = std::from_chars(text.data() + at + 1, text.data() + text.size(), seconds);
  if (error != std::errc() || end != text.data() + text.size() || !(seconds >= 0))
    throw InputError(
        fmt::format("--screenshot {}: @ must be followed by a number of seconds, e.g. FILE.png@2.5", text));
  return {text.substr(0, at), seconds};
}

std::string login_name() {
  const char* user = std::getenv("USER");
  return user != nullptr && *user != '\0' ? user : "guest";
}

std::string parse_language(const std::string& text) {
  if (text.empty()) return locale_language();
  std::string tag = text;
  std::ranges::replace(tag, '_', '-');
  if (!is_language_tag(tag))
    throw InputError(fmt::format("--language {}: must be a language tag, e.g. de, tr, pt-BR", text));
  return tag;
}

}  // namespace prosector
