#pragma once
// Glass with image-space refraction at its front and back, and reflections of the room. After Wyman, An
// approximate image-space approach for interactive refraction, ACM Trans. Graph. 24, 2005. A ray travels
// through the glass as far as the straight eye ray would. It leaves through the back face drawn at that
// point, and samples the frame behind. Two layers of glass are drawn, such as both walls of a dish; further
// layers are omitted. Private to client/render.

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

  /// Draws the list's glass items with refraction into `target`, which already contains all other surfaces.
  /// `main` shades the glass. Does nothing if no glass is visible.
  void draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes,
            const Shadow& shadow, const Environment& environment, RenderTarget& target, MainPass& main);

 private:
  /// Faces of one layer of glass, drawn into textures: their depth and, for back faces, their normals.
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
