#include "client/render/shadow_pass.h"

#include <algorithm>
#include <cmath>

#include "client/render/main_uniforms.h"
#include "common/rotation_between.h"

namespace prosector {
namespace {

/// Returns whether the item casts a shadow; glass does not.
bool casts_shadow(const DrawItem& item) {
  return item.casts_shadow && item.appearance.surface != Surface::glass;
}

/// Returns the spot light as a square camera, with its depth range fitted to the shadow casters.
DrawCamera camera_of(const LightInfo& light, const std::vector<QueuedItem>& items) {
  DrawCamera camera;
  camera.pose = {light.position, rotation_between(-Vec3::UnitZ(), light.direction.normalized())};
  const double widest = 1.3;  // rad; a wider cone has no shadows at its border
  const double tangent = std::tan(std::clamp(light.cone, 0.02, widest));
  camera.left = camera.bottom = -tangent;
  camera.right = camera.top = tangent;
  double nearest = 1e9, farthest = 0;
  for (const QueuedItem& queued : items) {
    if (!casts_shadow(*queued.item)) continue;
    const double depth = -(camera.pose.inverse() * queued.bounds.center).z();
    nearest = std::min(nearest, depth - queued.bounds.radius);
    farthest = std::max(farthest, depth + queued.bounds.radius);
  }
  // The range changes in steps, so that the layers stay valid while something moves.
  constexpr double step = 0.25;  // m
  camera.far = std::max(step * std::ceil(farthest / step), step);
  camera.near = std::clamp(step * std::floor(nearest / step), 0.01 * camera.far, 0.9 * camera.far);
  return camera;
}

/// Returns the item's clipping plane in its mesh's frame.
Eigen::Vector4d kept_of(const DrawItem& item, const std::optional<SectionPlane>& section) {
  if (!section || item.solid == 0) return no_clip_plane;
  return matrix_of(item).transpose() * clip_plane_of(*section);
}

}  // namespace

ShadowPass::ShadowPass(const Gl& gl, const std::filesystem::path& shaders, int size)
    : gl_(gl), program_(gl, shaders, "shadow"), size_(size), whole_(make_layer()), still_(make_layer()) {}

ShadowPass::~ShadowPass() {
  for (const Layer& layer : {whole_, still_}) {
    gl_.DeleteFramebuffers(1, &layer.framebuffer);
    gl_.DeleteTextures(1, &layer.depth);
  }
  if (!with_real_) return;
  gl_.DeleteFramebuffers(1, &with_real_->framebuffer);
  gl_.DeleteTextures(1, &with_real_->depth);
}

ShadowPass::Layer ShadowPass::make_layer() const {
  Layer layer;
  const int side = std::max(size_, 1);  // without shadows the sampler still needs a texture
  gl_.GenTextures(1, &layer.depth);
  gl_.BindTexture(GL_TEXTURE_2D, layer.depth);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl_.GenFramebuffers(1, &layer.framebuffer);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, layer.depth, 0);
  gl_.DrawBuffer(GL_NONE);
  gl_.ReadBuffer(GL_NONE);
  return layer;
}

Shadow ShadowPass::draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes) {
  Shadow shadow;
  shadow.texture = shadow.on_ground = whole_.depth;
  const auto spot = std::find_if(list.lights.begin(), list.lights.end(),
                                 [](const LightInfo& light) { return light.kind == LightKind::spot; });
  if (size_ < 3 || spot == list.lights.end()) return shadow;
  const DrawCamera camera = camera_of(*spot, items);
  shadow.light = static_cast<int>(spot - list.lights.begin());
  shadow.clip_from_room = view_projection_of(camera);
  shadow.size = size_;
  shadow.texel = 2 * camera.right / size_;

  const Frustum frustum(shadow.clip_from_room);
  Items casting, real;
  for (const QueuedItem& queued : items)
    if (casts_shadow(*queued.item) && frustum.may_see(queued.bounds))
      (queued.item->showing == ItemRole::real ? real : casting).push_back(&queued);
  if (note_changes(casting, shadow.clip_from_room, list.section)) draw_layers(casting, meshes);
  if (real.empty()) return shadow;
  add_real(real, meshes);
  shadow.texture = with_real_->depth;
  return shadow;
}

bool ShadowPass::note_changes(const Items& items, const Eigen::Matrix4d& clip_from_room,
                              const std::optional<SectionPlane>& section) {
  bool changed = clip_from_room != clip_from_room_ || section != section_ || items.size() != casters_.size();
  if (changed) in_still_.assign(items.size(), false);
  clip_from_room_ = clip_from_room;
  section_ = section;
  casters_.resize(items.size());
  unchanged_.resize(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) {
    const DrawItem& item = *items[k]->item;
    const Caster now{item.mesh->id, item.mesh->revision, item.mesh->positions_revision,
                     item.level,    item.pose,           item.shape};
    const bool same = now == casters_[k];
    unchanged_[k] = same ? unchanged_[k] + 1 : 0;
    changed = changed || !same;
    casters_[k] = now;
  }
  return changed;
}

void ShadowPass::draw_layers(const Items& items, const MeshCache& meshes) {
  std::vector<bool> is_still(items.size());
  Items still, moving;
  for (std::size_t k = 0; k < items.size(); ++k) {
    is_still[k] = unchanged_[k] >= frames_until_still;
    (is_still[k] ? still : moving).push_back(items[k]);
  }
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  if (is_still != in_still_ || still.empty()) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, still_.framebuffer);
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    draw_items(still, meshes);
    in_still_ = is_still;
  }
  copy(still_, whole_);
  draw_items(moving, meshes);
}

/// Draws the real items over a copy of whole_, into the layer with_real_.
void ShadowPass::add_real(const Items& items, const MeshCache& meshes) {
  if (!with_real_) with_real_ = make_layer();
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  copy(whole_, *with_real_);
  draw_items(items, meshes);
}

/// Copies a layer into another one, and binds the latter for drawing.
void ShadowPass::copy(const Layer& from, const Layer& to) const {
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
  gl_.BlitFramebuffer(0, 0, size_, size_, 0, 0, size_, size_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
}

void ShadowPass::draw_items(const Items& items, const MeshCache& meshes) const {
  gl_.Viewport(0, 0, size_, size_);
  // The outermost texels stay lit, because points outside the map take their value.
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(1, 1, size_ - 2, size_ - 2);
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(1.5F, 4.0F);
  program_.use();
  if (section_) gl_.Enable(GL_CLIP_DISTANCE0);
  for (const QueuedItem* queued : items) {
    program_.set("clip_from_mesh", Eigen::Matrix4d(clip_from_room_ * matrix_of(*queued->item)));
    set_clip_plane(program_, kept_of(*queued->item, section_));
    prosector::draw(meshes, *queued);
  }
  gl_.Disable(GL_CLIP_DISTANCE0);
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace prosector
