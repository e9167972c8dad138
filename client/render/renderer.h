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
  int samples = 1;        // coverage samples per pixel; shading is once per pixel and triangle
  int shadow_size = 768;  // texels, width and height of the first spot light's shadow map
  EffectSet effects = every_effect;
  bool occlusion = true;             // skips occluded items; does not change the frame
  int ambient_occlusion_pixels = 2;  // pixels, width and height, per sample of ambient occlusion
};

struct QualityLevel {
  std::string_view name;
  RendererSettings settings;
  double detail = 0.5;  // pixels of tolerated error for coarser triangles; 0: always in full
};
/// The levels of `--quality`; medium is the default.
inline constexpr std::array<QualityLevel, 3> quality_levels = {
    {{"low", {.shadow_size = 512, .effects = low_effects}},
     {"medium", {.effects = medium_effects}},
     {"high", {.samples = 4, .shadow_size = 1024, .ambient_occlusion_pixels = 1}}}};

/// The renderer, with one code path for every context. Everything is drawn into a separate target, so a frame
/// is the same with and without a window. With a window, `draw` also copies it there (call present() to show
/// it).
class Renderer {
 public:
  /// Stores a reference to `context`, which must outlive the renderer. `shaders` is the folder with the GLSL
  /// files (default_shader_dir()); empty: the embedded ones. Throws InputError with file and line if a shader
  /// does not compile, and InputError without fonts.
  Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings = {});
  ~Renderer();

  /// Draws the list. Throws std::invalid_argument if a mesh's normals, rest positions or triangles are
  /// inconsistent with its positions.
  void draw(const DrawList& list);
  /// Draws the list at another size than the context's, without showing it. Throws as draw() does.
  void draw(const DrawList& list, int width, int height);
  /// Copies the latest frame into a texture of the same size, as stored: sRGB-encoded.
  void copy_to(unsigned texture);
  /// Renders the list at another size into an image, without showing it. Throws as draw() does, and
  /// InputError if the size is too large.
  Image picture_of(const DrawList& list, int width, int height);
  /// Sets the settings for the following frames; as expensive as constructing the renderer. On error, throws
  /// as the constructor does and changes nothing.
  void set_settings(const RendererSettings& settings);
  /// Calls `done` with a pass's name after each pass, when its GPU work has finished; for measurement. Passes
  /// then no longer overlap, which costs time.
  void on_pass(std::function<void(std::string_view)> done);
  /// Reloads the shaders if a file was written since the last call; for development. Returns a message for
  /// the user: success, or file and line of a compile error, in which case the old shaders stay. nullopt: no
  /// file was written.
  std::optional<std::string> reload_changed_shaders();
  /// Waits until all drawing has finished; for measurement.
  void finish();
  /// Reads the latest frame.
  Image read_pixels();
  /// Returns how many items the latest frame omitted as occluded, for all cameras.
  std::size_t hidden() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
