#include "client/render/shadow_pass.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

/// The spot light as a square camera; depth is spent only on what casts shadows.
DrawCamera camera_of(const LightInfo& light, const std::vector<QueuedItem>& items) {
  DrawCamera camera;
  camera.pose = {light.position, Quat::FromTwoVectors(-Vec3::UnitZ(), light.direction.normalized())};
  const double widest = 1.3;  // rad; a wider cone is lit but unshadowed at its rim
  const double tangent = std::tan(std::clamp(light.cone, 0.02, widest));
  camera.left = camera.bottom = -tangent;
  camera.right = camera.top = tangent;
  double nearest = 1e9, farthest = 0;
  for (const QueuedItem& queued : items) {
    if (!queued.item->casts_shadow) continue;
    const double depth = -(camera.pose.inverse() * queued.bounds.center).z();
    nearest = std::min(nearest, depth - queued.bounds.radius);
    farthest = std::max(farthest, depth + queued.bounds.radius);
  }
  camera.far = std::max(farthest, 0.1);
  camera.near = std::clamp(nearest, 0.01 * camera.far, 0.9 * camera.far);
  return camera;
}

}  // namespace

ShadowPass::ShadowPass(const Gl& gl, const std::filesystem::path& shaders, int size)
    : gl_(gl), program_(gl, shaders, "shadow"), size_(size) {
  // A map of one lit texel stands in when there are no shadows, because the sampler needs some texture.
  const int side = std::max(size_, 1);
  gl_.GenTextures(1, &depth_);
  gl_.BindTexture(GL_TEXTURE_2D, depth_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, side, side, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                 nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  // Outside of the map all is lit.
  const float farthest[] = {1, 1, 1, 1};
  gl_.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl_.GenFramebuffers(1, &framebuffer_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  gl_.DrawBuffer(GL_NONE);
  gl_.ReadBuffer(GL_NONE);
}

ShadowPass::~ShadowPass() {
  gl_.DeleteFramebuffers(1, &framebuffer_);
  gl_.DeleteTextures(1, &depth_);
}

Shadow ShadowPass::draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes) {
  Shadow shadow;
  shadow.texture = depth_;
  const auto spot = std::find_if(list.lights.begin(), list.lights.end(),
                                 [](const LightInfo& light) { return light.kind == LightKind::spot; });
  if (size_ < 1 || spot == list.lights.end()) return shadow;
  const DrawCamera camera = camera_of(*spot, items);
  shadow.light = static_cast<int>(spot - list.lights.begin());
  shadow.clip_from_room = view_projection_of(camera);
  shadow.size = size_;
  shadow.texel = 2 * camera.right / size_;

  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  gl_.Viewport(0, 0, size_, size_);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5F, 4.0F);
  program_.use();
  const Frustum frustum(shadow.clip_from_room);
  for (const QueuedItem& queued : items) {
    if (!queued.item->casts_shadow || !frustum.may_see(queued.bounds)) continue;
    program_.set("clip_from_mesh", Eigen::Matrix4d(shadow.clip_from_room * matrix_of(queued.item->pose)));
    meshes.draw(queued.mesh);
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  return shadow;
}

}  // namespace prosector
