#include "client/render/screen_quad_drawer.h"

namespace prosector {

ScreenQuadDrawer::ScreenQuadDrawer(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), program_(gl, shaders, "screen"), stream_(gl, {3, 3}) {}

void ScreenQuadDrawer::draw(const std::vector<ScreenVertex>& vertices, bool depth_test) const {
  if (vertices.empty()) return;
  (depth_test ? gl_.Enable : gl_.Disable)(GL_DEPTH_TEST);
  program_.use();
  stream_.draw(vertices);
}

void ScreenQuadDrawer::draw_hidden(const std::vector<ScreenVertex>& vertices, float opacity) const {
  if (vertices.empty()) return;
  gl_.DepthFunc(GL_GREATER);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  gl_.BlendColor(0, 0, 0, opacity);
  draw(vertices, true);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
  gl_.DepthFunc(GL_LESS);
}

}  // namespace prosector
