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
/// Quality levels of the option `--quality`, from the fastest to the best: settings of the renderer and
/// tolerated error of coarser meshes. The default is medium.
inline constexpr std::array<QualityLevel, 3> quality_levels = {
    {{"low", {.shadow_size = 512, .effects = low_effects}},
     {"medium", {.effects = medium_effects}},
     {"high", {.samples = 4, .shadow_size = 1024, .ambient_occlusion_pixels = 1}}}};

/// Renderer of draw lists (surfaces, lights, lines and texts) for any OpenGL context. It draws into a
/// separate framebuffer, so a frame is the same with and without a window. With a window, draw() also copies
/// the frame there; call the context's present() to show it.
class Renderer {
 public:
  /// Creates the renderer and compiles its shaders. `context` must outlive the renderer. `shaders` is the
  /// folder with the GLSL files (default_shader_dir()); empty: the embedded ones. Throws InputError with file
  /// and line if a shader does not compile, and InputError if no font is installed.
  Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings = {});
  ~Renderer();

  /// Draws a frame of the list at the context's size and, if the context has a window, copies it there.
  /// Throws std::invalid_argument if a mesh's normals, rest positions or triangles are inconsistent with its
  /// positions.
  void draw(const DrawList& list);
  /// Draws a frame of the list, `width` × `height` pixels, without copying it to a window. Throws
  /// std::invalid_argument if a mesh's arrays are inconsistent.
  void draw(const DrawList& list, int width, int height);
  /// Copies the latest frame into an OpenGL texture of the same size. The values are copied as stored:
  /// sRGB-encoded.
  void copy_to(unsigned texture);
  /// Draws the list as an image of `width` × `height` pixels, without showing it in a window. Throws
  /// std::invalid_argument if a mesh's arrays are inconsistent, and InputError if the size is too large.
  Image picture_of(const DrawList& list, int width, int height);
  /// Sets the settings for the following frames. This recompiles the shaders and is as expensive as
  /// constructing the renderer. If a shader does not compile, throws InputError and changes nothing.
  void set_settings(const RendererSettings& settings);
  /// Sets a function that is called after each rendering pass with the pass's name, when its GPU work has
  /// finished. This is for measuring the time of passes, which then no longer overlap, so that a frame takes
  /// longer.
  void on_pass(std::function<void(std::string_view)> done);
  /// Recompiles the shaders if a file in the shader folder changed since the last call; for development.
  /// Returns a message for the user: success, or file and line of a compile error, in which case the old
  /// shaders stay. Returns nullopt if no file changed.
  std::optional<std::string> reload_changed_shaders();
  /// Waits until the GPU has finished all drawing commands; for measurement of frame times.
  void finish();
  /// Returns the latest frame as an image, read back from the GPU.
  Image read_pixels();
  /// Returns the number of items that were not drawn in the latest frame because they were occluded, for all
  /// cameras together.
  std::size_t hidden() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
