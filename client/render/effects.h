#pragma once
// What a picture may be spared: each effect can be left out by name, and what is left out costs nothing.

#include <array>
#include <bitset>
#include <string_view>

namespace prosector {

enum class Effect : std::uint8_t {
  relief,
  parallax,
  film,
  translucency,
  reflections,
  refraction,
  dispersion,
  shadows,
  shafts,
  edges,
  ambient_occlusion,
};

struct EffectRow {
  std::string_view name;   // on the command line
  const char* define;      // that shaders/main.* are compiled with when it is on; null: of no meaning there
  std::string_view about;  // for people
};

/// The effects' names, in the order of Effect.
inline constexpr std::array<EffectRow, 11> effect_rows = {{
    {"relief", "EFFECT_RELIEF", "bumps and hollows smaller than triangles, by their normals"},
    {"parallax", "EFFECT_PARALLAX", "what is high in a surface shifts against what is low"},
    {"film", "EFFECT_FILM", "the wet film's own highlights"},
    {"translucency", "EFFECT_TRANSLUCENCY", "light that wraps around tissue, red first"},
    {"reflections", "EFFECT_REFLECTIONS", "of the room in what is smooth"},
    {"refraction", "EFFECT_REFRACTION", "what is behind glass, bent by it"},
    {"dispersion", "EFFECT_DISPERSION", "glass bends blue more than red"},
    {"shadows", nullptr, "of the first spot light"},
    {"shafts", nullptr, "dust in the lamp's beam"},
    {"edges", nullptr, "smooth, where there is one sample per pixel"},
    {"ambient_occlusion", nullptr, "less light from around in creases and where things touch"},
}};

using EffectSet = std::bitset<effect_rows.size()>;

constexpr std::size_t index_of(Effect effect) {
  return static_cast<std::size_t>(effect);
}

inline bool has(const EffectSet& set, Effect effect) {
  return set[index_of(effect)];
}

}  // namespace prosector
