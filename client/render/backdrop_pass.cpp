#include "client/render/backdrop_pass.h"

#include "client/render/main_uniforms.h"

namespace prosector {

BackdropPass::BackdropPass(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), program_(gl, shaders, "backdrop"), uncover_(gl, shaders, "uncover") {
  gl_.GenVertexArrays(1, &no_vertices_);
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
}

BackdropPass::~BackdropPass() {
  gl_.DeleteTextures(1, &texture_);
  gl_.DeleteVertexArrays(1, &no_vertices_);
}

void BackdropPass::upload(const DrawBackdrop& backdrop) {
  const Image& image = *backdrop.image;
  const bool fits = image.width == width_ && image.height == height_;
  if (fits && backdrop.number == number_) return;
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  if (fits)
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE,
                      image.rgb.data());
  else
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                   image.rgb.data());
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  width_ = image.width;
  height_ = image.height;
  number_ = backdrop.number;
}

void BackdropPass::set_image(const ShaderProgram& program, const DrawBackdrop& backdrop,
                             const DrawCamera& camera) {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  upload(backdrop);
  program.use();
  program.set("picture", 0);
  // The window's rows start at the bottom, the image's at the top.
  const double bottom = backdrop.top + backdrop.step * (camera.y + camera.height);
  program.set("place", std::vector<Eigen::Vector4f>{Eigen::Vector4d(backdrop.left - backdrop.step * camera.x,
                                                                    bottom, backdrop.step, -backdrop.step)
                                                        .cast<float>()});
}

void BackdropPass::draw(const DrawBackdrop& backdrop, const DrawCamera& camera) {
  set_image(program_, backdrop, camera);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.BindVertexArray(no_vertices_);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
  gl_.DepthMask(GL_TRUE);
}

// Writes no depth: at a finger's soft border, the parts of the hand behind it still occlude.
void BackdropPass::uncover(const DrawBackdrop& backdrop, const DrawCamera& camera,
                           const std::vector<QueuedItem>& items, const MeshCache& meshes) {
  set_image(uncover_, backdrop, camera);
  uncover_.set("clip_from_room", view_projection_of(camera));
  uncover_.set("eye", camera.pose.p);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_CULL_FACE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  for (const QueuedItem& queued : items) {
    if (queued.item->showing != ItemRole::real) continue;
    set_placement(uncover_, *queued.item);
    prosector::draw(meshes, queued);
  }
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
  gl_.DepthMask(GL_TRUE);
}

}  // namespace prosector
