#pragma once
// Lit surfaces: one shader program for each kind of Surface, wet or dry, and set of lights. Private to
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

/// Tells whether the item is glass, and whole: a painted one, or one that a panel makes half seen through, is
/// drawn as any other.
bool is_glass(const DrawItem& item);

class MainPass {
 public:
  /// Takes in `defines` what all of its shaders are compiled with.
  MainPass(const Gl& gl, const std::filesystem::path& shaders, std::vector<std::string> defines);

  /// Compiles every kind of surface, so that a broken shader shows at once.
  void compile_all();

  /// Draws the list. `items` come nearest first, so that hidden fragments are not shaded. What is seen
  /// through comes after all that is not, farthest first, and light in air last. Ground comes first, real
  /// things are left to BackdropPass. With `occlusion`, what is hidden is not drawn.
  void draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
            const MeshCache& meshes, const Shadow& shadow, const Environment& environment,
            Occlusion* occlusion = nullptr);

  /// Draws one layer of glass; draw() leaves out what is drawn by this (GlassPass).
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
  void draw_clear(const QueuedItem& queued, Frame& frame);
  void draw_pane(const QueuedItem& queued, Frame& frame);
  void draw_ground(const std::vector<const QueuedItem*>& grounds, Frame& frame);
  void draw_shaft(const QueuedItem& queued, Frame& frame);

  const Gl& gl_;
  std::filesystem::path shaders_;
  std::vector<std::string> defines_;
  bool refracts_;  // glass is drawn by draw_glass()
  bool probes_;    // draws what is around, for mirrors
  std::map<Defines, std::unique_ptr<ShaderProgram>> programs_;
};

}  // namespace prosector
