#pragma once
// Glass: what is behind it, bent by its front and its back, and the room mirrored in it. After Wyman, An
// approximate image-space approach for interactive refraction, ACM Trans. Graph. 24, 2005. A ray goes from
// the front face as far through the glass as the eye's own ray would. It leaves through the back face that is
// drawn there, and meets what the picture holds. Two layers of glass are seen through, such as both walls of
// a dish; more are left out. Private to client/render.

#include <array>

#include "client/render/main_pass.h"
#include "client/render/render_target.h"

namespace prosector {

class GlassPass {
 public:
  GlassPass(const Gl& gl, const std::filesystem::path& shaders);
  ~GlassPass();
  GlassPass(const GlassPass&) = delete;
  GlassPass& operator=(const GlassPass&) = delete;

  /// Draws into `target`, which holds everything that isn't glass; `main` shades it. Draws nothing and costs
  /// nothing where no glass is seen.
  void draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes,
            const Shadow& shadow, const Environment& environment, RenderTarget& target, MainPass& main);

 private:
  /// The faces of one layer: how deep they are, and of back faces where they look.
  struct Faces {
    GLuint framebuffer = 0, depth = 0, normals = 0;
  };
  struct Layer {
    Faces front, back;
  };

  const Gl& gl_;
  ShaderProgram faces_;
  std::array<Layer, 2> layers_;  // the nearer one first
  int width_ = 0, height_ = 0;

  void allocate(int width, int height);
  void release();
  void draw_faces(const DrawCamera& camera, const std::vector<const QueuedItem*>& glass,
                  const MeshCache& meshes, const Faces& faces, GLuint nearer, GLuint scene_depth);
};

}  // namespace prosector
