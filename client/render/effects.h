#pragma once
// Optional rendering effects. Each can be disabled by name; a disabled effect costs nothing.

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
  std::string_view name;  // on the command line
  // Macro with which shaders/main.* are compiled when the effect is on; null: not used there.
  const char* define;
  std::string_view about;  // description for users
};

/// Names, shader macros and descriptions of the optional rendering effects, in the order of enum Effect.
inline constexpr std::array<EffectRow, 11> effect_rows = {{
    {"relief", "EFFECT_RELIEF", "fine surface relief by perturbed normals"},
    {"parallax", "EFFECT_PARALLAX", "parallax of the surface relief"},
    {"film", "EFFECT_FILM", "highlights of the wet film"},
    {"translucency", "EFFECT_TRANSLUCENCY", "light scattered below the surface of tissue"},
    {"reflections", "EFFECT_REFLECTIONS", "reflections of the room in smooth surfaces"},
    {"refraction", "EFFECT_REFRACTION", "refraction behind glass"},
    {"dispersion", "EFFECT_DISPERSION", "chromatic dispersion in glass"},
    {"shadows", nullptr, "shadows of the first spot light"},
    {"shafts", nullptr, "visible beam of the lamp"},
    {"edges", nullptr, "smooth edges with one sample per pixel"},
    {"ambient_occlusion", nullptr, "ambient occlusion in creases and at contacts"},
}};

using EffectSet = std::bitset<effect_rows.size()>;

constexpr std::size_t index_of(Effect effect) {
  return static_cast<std::size_t>(effect);
}

inline bool has(const EffectSet& set, Effect effect) {
  return set[index_of(effect)];
}

}  // namespace prosector
