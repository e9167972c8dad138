#pragma once
// Lit surfaces: one shader program for each combination of Surface, wetness and set of lights. Private to
// client/render.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "client/render/environment.h"
#include "client/render/occlusion.h"
#include "client/render/refraction.h"
#include "client/render/shadow_pass.h"

namespace prosector {

/// Returns whether the item is drawn as glass: its surface is glass, it has no colours painted on it, and no
/// panel made it transparent.
bool is_glass(const DrawItem& item);

class MainPass {
 public:
  /// Creates the pass without compiling shaders. `shaders` is the folder with the GLSL files, empty for the
  /// embedded ones. All shaders of the pass are compiled with the macros `defines`.
  MainPass(const Gl& gl, const std::filesystem::path& shaders, std::vector<std::string> defines);

  /// Compiles a shader for every kind of surface now rather than when it is first drawn, so that errors in
  /// shader files are detected immediately.
  void compile_all();

  /// Draws the list's surfaces as this camera sees them. `items` must be sorted nearest first, so that hidden
  /// fragments are not shaded. Ground (real surfaces that receive shadows) is drawn first, then opaque items,
  /// then transparent ones, farthest first, and light shafts last.
  ///
  /// Items of role `real` are left to BackdropPass; glass with refraction, to draw_glass(). With `occlusion`,
  /// occluded items are not drawn.
  void draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
            const MeshCache& meshes, const Shadow& shadow, const Environment& environment,
            Occlusion* occlusion = nullptr);

  /// Draws one layer of glass with refraction, for GlassPass. `seen` holds the frame so far and the layer's
  /// faces. If refraction is enabled, draw() omits glass except in insets, where it has no refraction.
  void draw_glass(const DrawList& list, const DrawCamera& camera, const std::vector<const QueuedItem*>& glass,
                  const MeshCache& meshes, const Shadow& shadow, const Environment& environment,
                  const Refraction& seen);

 private:
  using Defines = std::vector<std::string>;

  struct Frame;

  const ShaderProgram& program_for(const Defines& defines);
  const ShaderProgram& ready(const QueuedItem& queued, Frame& frame);
  template <class Draw>
  void draw_sides(const QueuedItem& queued, Frame& frame, const Draw& draw);
  void bind_shadow(GLuint texture) const;
  void draw_solid(const QueuedItem& queued, Frame& frame);
  void draw_transparent(const QueuedItem& queued, Frame& frame);
  void draw_unrefracted_glass(const QueuedItem& queued, Frame& frame);
  void draw_ground(const std::vector<const QueuedItem*>& grounds, Frame& frame);
  void draw_shaft(const QueuedItem& queued, Frame& frame);

  const Gl& gl_;
  std::filesystem::path shaders_;
  std::vector<std::string> defines_;
  bool refracts_;  // draw_glass() draws the glass
  bool probes_;    // draws the environment map
  std::map<Defines, std::unique_ptr<ShaderProgram>> programs_;
};

}  // namespace prosector
