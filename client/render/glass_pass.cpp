#include "client/render/glass_pass.h"

#include "client/render/main_uniforms.h"
#include "client/render/refraction.h"

namespace prosector {

GlassPass::GlassPass(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), faces_(gl, shaders, "glass_faces") {}

GlassPass::~GlassPass() {
  release();
}

void GlassPass::release() {
  for (Layer& layer : layers_)
    for (Faces* faces : {&layer.front, &layer.back}) {
      gl_.DeleteFramebuffers(1, &faces->framebuffer);
      gl_.DeleteTextures(1, &faces->depth);
      gl_.DeleteTextures(1, &faces->normals);
      *faces = {};
    }
}

void GlassPass::allocate(int width, int height) {
  if (width == width_ && height == height_) return;
  release();
  width_ = width;
  height_ = height;
  const auto texture = [&](GLenum format, GLenum layout, GLenum type, GLenum attachment) {
    GLuint id = 0;
    gl_.GenTextures(1, &id);
    gl_.BindTexture(GL_TEXTURE_2D, id);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, layout, type, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, id, 0);
    return id;
  };
  gl_.ActiveTexture(GL_TEXTURE0);
  for (Layer& layer : layers_)
    for (Faces* faces : {&layer.front, &layer.back}) {
      gl_.GenFramebuffers(1, &faces->framebuffer);
      gl_.BindFramebuffer(GL_FRAMEBUFFER, faces->framebuffer);
      faces->depth = texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, GL_DEPTH_ATTACHMENT);
      if (faces == &layer.back)
        faces->normals = texture(GL_RGBA16F, GL_RGBA, GL_FLOAT, GL_COLOR_ATTACHMENT0);
      else
        gl_.DrawBuffer(GL_NONE), gl_.ReadBuffer(GL_NONE);
    }
}

/// Draws the nearest faces beyond those of `nearer` (0: all). Faces behind `scene_depth` are skipped (0: none
/// are). For front faces, `faces` has no normals texture.
void GlassPass::draw_faces(const DrawCamera& camera, const std::vector<const QueuedItem*>& glass,
                           const MeshCache& meshes, const Faces& faces, GLuint nearer, GLuint scene_depth) {
  const bool back = faces.normals != 0;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, faces.framebuffer);
  gl_.Viewport(camera.x, camera.y, camera.width, camera.height);
  faces_.use();
  faces_.set("clip_from_room", view_projection_of(camera));
  faces_.set("nearer", 0);
  faces_.set("scene_depth", 1);
  faces_.set("is_peeled", nearer != 0);
  faces_.set("is_hidden", scene_depth != 0);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, scene_depth);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, nearer);
  for (const QueuedItem* queued : glass) {
    set_placement(faces_, *queued->item);
    gl_.CullFace((queued->item->shape.A.determinant() < 0) == back ? GL_BACK : GL_FRONT);
    prosector::draw(meshes, *queued);
  }
}

void GlassPass::draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes,
                     const Shadow& shadow, const Environment& environment, RenderTarget& target,
                     MainPass& main) {
  for (const DrawCamera& camera : list.cameras) {
    if (camera.inset) continue;
    const Frustum frustum(view_projection_of(camera));
    std::vector<const QueuedItem*> glass;
    for (const QueuedItem& queued : items)
      if (is_glass(*queued.item) && frustum.may_see(queued.bounds)) glass.push_back(&queued);
    if (glass.empty()) continue;
    allocate(target.width(), target.height());
    const GLuint scene_depth = target.depth();
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthMask(GL_TRUE);
    gl_.Enable(GL_CULL_FACE);
    gl_.ClearColor(0, 0, 0, 0);
    GLuint nearer = 0;
    for (const Layer& layer : layers_)
      for (const Faces* faces : {&layer.front, &layer.back}) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, faces->framebuffer);
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_faces(camera, glass, meshes, *faces, nearer, faces == &layer.front ? scene_depth : 0);
        nearer = faces->depth;
      }
    for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
      const Refraction seen{target.picture(), scene_depth, layer->front.depth, layer->back.depth,
                            layer->back.normals};
      target.bind_again();
      gl_.Viewport(camera.x, camera.y, camera.width, camera.height);
      main.draw_glass(list, camera, glass, meshes, shadow, environment, seen);
    }
  }
}

}  // namespace prosector
