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

}  // namespace prosector
