#pragma once
// Draws a DrawList with OpenGL 3.3 core. The only consumer of DrawList, and the only code with shaders.

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "client/render/effects.h"
#include "client/render/gl_context.h"
#include "client/render/image.h"
#include "client/render/shader_dir.h"
#include "client/view/draw_list.h"

namespace prosector {

inline constexpr EffectSet every_effect = (1U << effect_rows.size()) - 1;
inline constexpr EffectSet low_effects = 1U << index_of(Effect::relief) | 1U << index_of(Effect::film) |
                                         1U << index_of(Effect::translucency) |
                                         1U << index_of(Effect::shadows);
inline constexpr EffectSet medium_effects =
    ((1U << effect_rows.size()) - 1) & ~(1U << index_of(Effect::shafts));

struct RendererSettings {
  int samples = 1;        // of coverage per pixel; shading is once per pixel and triangle
  int shadow_size = 768;  // texels, each way, of the first spot light's shadow map
  EffectSet effects = every_effect;
  bool occlusion = true;    // what other things hide is not drawn; the picture is the same
  int ambient_coarser = 2;  // pixels, each way, that one place of ambient occlusion stands for
};

struct QualityLevel {
  std::string_view name;
  RendererSettings settings;
  double detail = 0.5;  // pixels by which surfaces may be off to be drawn with fewer triangles; 0: never
};
/// What `--quality` chooses from; medium is the default.
inline constexpr std::array<QualityLevel, 3> quality_levels = {
    {{"low", {.shadow_size = 512, .effects = low_effects}},
     {"medium", {.effects = medium_effects}},
     {"high", {.samples = 4, .shadow_size = 1024, .ambient_coarser = 1}}}};

/// One code path for every context. Everything is drawn into a target of its own, so a picture is the same
/// with and without a window. With a window, `draw` also copies it there (call present() to show it).
class Renderer {
 public:
  /// Takes a `context` that outlives the renderer. `shaders` is the folder with the GLSL files
  /// (default_shader_dir()); empty: those that are part of the program. Throws InputError with file and line
  /// when one does not compile, and when there is no font to write with.
  Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings = {});
  ~Renderer();

  /// Draws the list. Throws std::invalid_argument when a mesh's normals, rest positions or triangles don't
  /// fit its positions.
  void draw(const DrawList& list);
  /// Draws the list at another size than the context's, and shows it nowhere. Throws as draw() does.
  void draw(const DrawList& list, int width, int height);
  /// Copies what was drawn last into a texture of its size, as it is stored: encoded as sRGB.
  void copy_to(unsigned texture);
  /// Returns the list at another size, shown nowhere. Throws as draw() does, and InputError where the size is
  /// too large.
  Image picture_of(const DrawList& list, int width, int height);
  /// Sets the settings from the next picture on; costs what making the renderer does. Throws as it does, and
  /// then nothing changed.
  void set_settings(const RendererSettings& settings);
  /// Calls `done` after each pass with its name, when all its work is done; for measurement. This costs:
  /// passes no longer overlap.
  void on_pass(std::function<void(std::string_view)> done);
  /// Reads the shaders anew when a file of them was written since the last call; for development. Returns
  /// what came of it, for people: done, or file and line of what does not compile, and then the old shaders
  /// stay. nullopt: nothing was written.
  std::optional<std::string> reload_changed_shaders();
  /// Waits until all that was drawn is there; for measurement.
  void finish();
  /// Reads what was drawn last.
  Image read_pixels();
  /// Returns how many items the last picture's cameras left out because other things hide them.
  std::size_t hidden() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
