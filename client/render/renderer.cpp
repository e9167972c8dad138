#include "client/render/renderer.h"

#include <algorithm>

#include "client/render/line_pass.h"
#include "client/render/main_pass.h"
#include "client/render/render_target.h"
#include "client/render/text_pass.h"

namespace prosector {

struct Renderer::Impl {
  Impl(GlContext& gl_context, const std::filesystem::path& shaders, const RendererSettings& settings)
      : context(gl_context),
        gl(load_gl(gl_context)),
        target(gl, settings.samples),
        meshes(gl),
        shadow_pass(gl, shaders, settings.shadow_size),
        main_pass(gl, shaders),
        screen_quads(gl, shaders) {}

  std::vector<QueuedItem> upload(const DrawList& list);
  void clear(const DrawCamera& camera, const Vec3& background) const;

  GlContext& context;
  Gl gl;
  RenderTarget target;
  MeshCache meshes;
  ShadowPass shadow_pass;
  MainPass main_pass;
  ScreenQuadDrawer screen_quads;
};

namespace {

// IEC 61966-2-1, the inverse of what a screen does.
float srgb(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

void sort_nearest_first(std::vector<QueuedItem>& items, const Vec3& eye) {
  const auto distance = [&](const QueuedItem& q) { return (q.bounds.center - eye).norm() - q.bounds.radius; };
  std::stable_sort(items.begin(), items.end(),
                   [&](const QueuedItem& a, const QueuedItem& b) { return distance(a) < distance(b); });
}

}  // namespace

Renderer::Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings)
    : impl_(std::make_unique<Impl>(context, shaders, settings)) {}

Renderer::~Renderer() = default;

std::vector<QueuedItem> Renderer::Impl::upload(const DrawList& list) {
  meshes.begin_frame();
  std::vector<QueuedItem> items;
  items.reserve(list.items.size());
  for (const DrawItem& item : list.items) {
    if (!item.mesh) continue;
    const MeshCache::Entry& mesh = meshes.upload(*item.mesh);
    items.push_back({&item, mesh, {item.pose * mesh.bounds.center, mesh.bounds.radius}});
  }
  return items;
}

void Renderer::Impl::clear(const DrawCamera& camera, const Vec3& background) const {
  gl.Viewport(camera.x, camera.y, camera.width, camera.height);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(camera.x, camera.y, camera.width, camera.height);
  gl.ClearColor(srgb(background.x()), srgb(background.y()), srgb(background.z()), 1);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Renderer::draw(const DrawList& list) {
  Impl& r = *impl_;
  std::vector<QueuedItem> items = r.upload(list);
  const Shadow shadow = r.shadow_pass.draw(list, items, r.meshes);
  r.target.bind(r.context.width(), r.context.height());
  for (const DrawCamera& camera : list.cameras) {
    r.clear(camera, list.background);
    sort_nearest_first(items, camera.pose.p);
    r.main_pass.draw(list, camera, items, r.meshes, shadow);
    draw_lines(list, camera, r.screen_quads);
    draw_texts(list, camera, r.screen_quads);
  }
  r.target.resolve(r.context.has_screen());
}

Image Renderer::read_pixels() {
  return impl_->target.read();
}

}  // namespace prosector
