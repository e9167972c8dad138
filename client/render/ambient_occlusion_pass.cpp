#include "client/render/ambient_occlusion_pass.h"

namespace prosector {
namespace {

constexpr double radius = 0.05;  // m: of the ball around a point

}  // namespace

AmbientOcclusionPass::AmbientOcclusionPass(const Gl& gl, const std::filesystem::path& shaders, int coarser)
    : gl_(gl),
      coarser_(coarser),
      open_(gl, shaders, "ambient_occlusion", {"COARSER " + std::to_string(coarser)}),
      blend_(gl, shaders, "ambient_occlusion_blend", {"COARSER " + std::to_string(coarser)}) {
  gl_.GenVertexArrays(1, &no_vertices_);
  gl_.GenTextures(1, &openness_);
  gl_.BindTexture(GL_TEXTURE_2D, openness_);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  allocate(1, 1);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, openness_, 0);
}

AmbientOcclusionPass::~AmbientOcclusionPass() {
  gl_.DeleteVertexArrays(1, &no_vertices_);
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteTextures(1, &openness_);
}

void AmbientOcclusionPass::allocate(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  gl_.BindTexture(GL_TEXTURE_2D, openness_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
}

void AmbientOcclusionPass::draw(const DrawList& list, RenderTarget& target) {
  const GLuint depth = target.depth();
  gl_.ActiveTexture(GL_TEXTURE0);
  allocate((target.width() + coarser_ - 1) / coarser_, (target.height() + coarser_ - 1) / coarser_);
  gl_.BindVertexArray(no_vertices_);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.ClearColor(1, 1, 1, 1);
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.BindTexture(GL_TEXTURE_2D, depth);
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) draw_openness(camera);
  target.bind_again();
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, openness_);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  for (const DrawCamera& camera : list.cameras)
    if (!camera.inset) lay_over(camera);
  gl_.Disable(GL_BLEND);
}

void AmbientOcclusionPass::set_lens(const ShaderProgram& program, const DrawCamera& camera) const {
  program.set("scene_depth", 0);
  program.set("lens", std::vector<Eigen::Vector4f>{
                          Eigen::Vector4d(1 / camera.near, 1 / camera.far,
                                          camera.height / (camera.top - camera.bottom), radius)
                              .cast<float>()});
  program.set("viewport",
              std::vector<Eigen::Vector4f>{
                  Eigen::Vector4i(camera.x, camera.y, camera.width, camera.height).cast<float>()});
}

void AmbientOcclusionPass::draw_openness(const DrawCamera& camera) const {
  gl_.Viewport(camera.x / coarser_, camera.y / coarser_, (camera.width + coarser_ - 1) / coarser_,
               (camera.height + coarser_ - 1) / coarser_);
  open_.use();
  set_lens(open_, camera);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void AmbientOcclusionPass::lay_over(const DrawCamera& camera) const {
  gl_.Viewport(camera.x, camera.y, camera.width, camera.height);
  blend_.use();
  set_lens(blend_, camera);
  blend_.set("openness", 1);
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace prosector
