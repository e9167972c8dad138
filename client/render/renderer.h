#pragma once
// Draws a DrawList with OpenGL 3.3 core. The only consumer of DrawList, and the only code with shaders.

#include <array>
#include <filesystem>
#include <memory>
#include <string_view>

#include "client/render/gl_context.h"
#include "client/render/image.h"
#include "client/render/shader_dir.h"
#include "client/view/draw_list.h"

namespace prosector {

struct RendererSettings {
  int samples = 1;           // of coverage per pixel; shading is once per pixel and triangle
  bool smooth_edges = true;  // with 1 sample: steps along edges are blended in the finished picture
  int shadow_size = 768;     // texels, each way, of the first spot light's shadow map; 0: no shadows
};

struct QualityLevel {
  std::string_view name;
  RendererSettings settings;
};
/// What `--quality` chooses from; medium is the default.
inline constexpr std::array<QualityLevel, 3> quality_levels = {
    {{"low", {1, false, 512}}, {"medium", {}}, {"high", {4, false, 1024}}}};

/// One code path for every context. Everything is drawn into a target of its own, so a picture is the same
/// with and without a window; with a window, `draw` also copies it there (call present() to show it).
class Renderer {
 public:
  /// `context` outlives the renderer. `shaders` is the folder with the GLSL files (default_shader_dir()).
  /// Throws InputError with file and line when one does not compile.
  Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings = {});
  ~Renderer();

  /// Throws std::invalid_argument when a mesh's normals, rest positions or triangles don't fit its positions.
  void draw(const DrawList& list);
  /// What was drawn last.
  Image read_pixels();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
