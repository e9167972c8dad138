#include "client/render/renderer.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "client/render/ambient_occlusion_pass.h"
#include "client/render/backdrop_pass.h"
#include "client/render/environment_pass.h"
#include "client/render/glass_pass.h"
#include "client/render/line_pass.h"
#include "client/render/main_pass.h"
#include "client/render/render_target.h"
#include "client/render/shader_watch.h"
#include "client/render/shaft_pass.h"
#include "client/render/text_pass.h"
#include "common/error.h"

namespace prosector {
namespace {

std::vector<std::string> effect_defines(const EffectSet& effects) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < effect_rows.size(); ++k)
    if (effects[k] && effect_rows[k].define != nullptr) out.emplace_back(effect_rows[k].define);
  return out;
}

// IEC 61966-2-1: linear light to sRGB.
float srgb(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}

void sort_nearest_first(std::vector<QueuedItem>& items, const Vec3& eye) {
  const auto distance = [&](const QueuedItem& q) { return (q.bounds.center - eye).norm() - q.bounds.radius; };
  std::stable_sort(items.begin(), items.end(),
                   [&](const QueuedItem& a, const QueuedItem& b) { return distance(a) < distance(b); });
}

/// All objects with shaders, in drawing order.
struct Passes {
  Passes(const Gl& gl, const std::filesystem::path& shaders, const RendererSettings& settings,
         Typesetter& typesetter)
      : target(gl, shaders, settings),
        shadow(gl, shaders, has(settings.effects, Effect::shadows) ? settings.shadow_size : 0),
        environment(gl, shaders),
        backdrop(gl, shaders),
        main(gl, shaders, effect_defines(settings.effects)),
        lines(gl, shaders),
        texts(gl, shaders, typesetter) {
    main.compile_all();
    if (settings.occlusion) occlusion.emplace(gl, shaders);
    if (has(settings.effects, Effect::ambient_occlusion))
      ambient.emplace(gl, shaders, settings.ambient_occlusion_pixels);
    if (has(settings.effects, Effect::refraction)) glass.emplace(gl, shaders);
    if (has(settings.effects, Effect::shafts)) shafts.emplace(gl, shaders);
  }

  RenderTarget target;
  ShadowPass shadow;
  EnvironmentPass environment;
  BackdropPass backdrop;
  MainPass main;
  std::optional<Occlusion> occlusion;           // nullopt: everything is drawn
  std::optional<AmbientOcclusionPass> ambient;  // nullopt: disabled
  std::optional<GlassPass> glass;               // nullopt: drawn by `main` without refraction
  std::optional<ShaftPass> shafts;              // nullopt: disabled
  ScreenQuadDrawer lines;
  TextPass texts;
  // Light kinds for which the shaders of future users' avatars are compiled.
  std::vector<LightKind> prepared_lights;
};

}  // namespace

struct Renderer::Impl {
  Impl(GlContext& gl_context, const std::filesystem::path& folder, const RendererSettings& chosen)
      : context(gl_context),
        shaders(folder),
        settings(chosen),
        gl(load_gl(gl_context)),
        meshes(gl),
        watch(folder),
        passes(std::make_unique<Passes>(gl, folder, chosen, typesetter)) {
    auto point = std::make_shared<DrawMesh>();
    point->id = std::numeric_limits<std::uint64_t>::max();
    point->positions.assign(3, Eigen::Vector3f::Zero());
    point->normals.assign(3, Eigen::Vector3f::UnitY());
    point->rest_positions = point->positions;
    point->triangles = {{0, 1, 2}};
    for (const Surface surface : {Surface::plain, Surface::skin, Surface::emissive})
      users_to_come.push_back(
          {.mesh = point, .pose = {}, .appearance = {.surface = surface}, .casts_shadow = false});
  }

  std::vector<QueuedItem> upload(const DrawList& list);
  void prepare_for_users(const DrawList& list, std::vector<QueuedItem>& items);
  void clear(const DrawCamera& camera, const Vec3& background) const;
  void set_viewport(const DrawCamera& camera) const {
    gl.Viewport(camera.x, camera.y, camera.width, camera.height);
  }

  void finish_pass(std::string_view pass) const {
    if (!pass_done) return;
    gl.Finish();
    pass_done(pass);
  }

  GlContext& context;
  std::filesystem::path shaders;
  RendererSettings settings;
  Gl gl;
  MeshCache meshes;
  Typesetter typesetter;
  ShaderWatch watch;
  std::unique_ptr<Passes> passes;
  std::function<void(std::string_view)> pass_done;
  std::vector<DrawItem> users_to_come;  // invisible items with the surface kinds of avatars
};

Renderer::Renderer(GlContext& context, const std::filesystem::path& shaders, const RendererSettings& settings)
    : impl_(std::make_unique<Impl>(context, shaders, settings)) {}

Renderer::~Renderer() = default;

std::vector<QueuedItem> Renderer::Impl::upload(const DrawList& list) {
  meshes.begin_frame();
  std::vector<QueuedItem> items;
  items.reserve(list.items.size());
  for (const DrawItem& item : list.items) {
    if (!item.mesh) continue;
    const MeshCache::Entry& mesh = meshes.upload(*item.mesh, item.detail);
    items.push_back({&item, &mesh, placed(mesh.bounds, item)});
  }
  return items;
}

// Drivers compile a shader at its first use. To avoid a delay when users join later, a degenerate triangle
// triggers the compilation in the scene's first frame.
void Renderer::Impl::prepare_for_users(const DrawList& list, std::vector<QueuedItem>& items) {
  std::vector<LightKind> kinds;
  for (const LightInfo& light : list.lights) kinds.push_back(light.kind);
  if (kinds == passes->prepared_lights || list.cameras.empty()) return;
  passes->prepared_lights = kinds;
  for (const DrawItem& item : users_to_come)
    items.push_back({&item, &meshes.upload(*item.mesh), {list.cameras[0].pose.p, 1e3}});
}

void Renderer::Impl::clear(const DrawCamera& camera, const Vec3& background) const {
  set_viewport(camera);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(camera.x, camera.y, camera.width, camera.height);
  gl.ClearColor(srgb(background.x()), srgb(background.y()), srgb(background.z()), 1);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
}

void Renderer::draw(const DrawList& list) {
  Impl& r = *impl_;
  draw(list, r.context.width(), r.context.height());
  if (r.context.has_screen()) r.passes->target.show();
}

Image Renderer::picture_of(const DrawList& list, int width, int height) {
  check_picture_size(width, height);
  draw(list, width, height);
  return read_pixels();
}

void Renderer::draw(const DrawList& list, int width, int height) {
  Impl& r = *impl_;
  Passes& passes = *r.passes;
  std::vector<QueuedItem> items = r.upload(list);
  r.prepare_for_users(list, items);
  r.finish_pass("upload");
  const Shadow shadow = passes.shadow.draw(list, items, r.meshes);
  r.finish_pass("shadow");
  const Environment& environment = passes.environment.draw(list, items, r.meshes);
  r.finish_pass("environment");
  passes.target.bind(width, height);
  Occlusion* const occlusion = passes.occlusion ? &*passes.occlusion : nullptr;
  if (occlusion != nullptr) occlusion->begin_picture();
  const auto draw_surfaces = [&](bool insets) {
    for (const DrawCamera& camera : list.cameras) {
      if (camera.inset != insets) continue;
      r.clear(camera, list.background);
      if (list.backdrop && !insets) passes.backdrop.draw(*list.backdrop, camera);
      sort_nearest_first(items, camera.pose.p);
      passes.main.draw(list, camera, items, r.meshes, shadow, environment, occlusion);
    }
  };
  draw_surfaces(false);
  r.finish_pass("surfaces");
  if (passes.ambient) passes.ambient->draw(list, passes.target);
  r.finish_pass("ambient_occlusion");
  if (passes.glass)
    passes.glass->draw(list, items, r.meshes, shadow, environment, passes.target, passes.main);
  r.finish_pass("glass");
  if (passes.shafts && !list.backdrop) passes.shafts->draw(list, shadow, passes.target);
  r.finish_pass("shafts");
  if (list.backdrop)
    for (const DrawCamera& camera : list.cameras) {
      if (camera.inset) continue;
      r.set_viewport(camera);
      passes.backdrop.uncover(*list.backdrop, camera, items, r.meshes);
    }
  for (const DrawCamera& camera : list.cameras) {
    if (camera.inset) continue;
    r.set_viewport(camera);
    draw_lines(list, camera, passes.lines);
    passes.texts.draw_on_surfaces(list, camera);
  }
  r.finish_pass("lines");
  draw_surfaces(true);
  r.finish_pass("insets");
  passes.target.resolve();
  r.finish_pass("edges");
  for (const DrawCamera& camera : list.cameras) {
    if (camera.inset) continue;
    r.set_viewport(camera);
    passes.texts.draw_over(list, camera);
  }
  r.finish_pass("texts");
}

void Renderer::set_settings(const RendererSettings& settings) {
  impl_->passes = std::make_unique<Passes>(impl_->gl, impl_->shaders, settings, impl_->typesetter);
  impl_->settings = settings;
}

void Renderer::on_pass(std::function<void(std::string_view)> done) {
  impl_->pass_done = std::move(done);
}

std::optional<std::string> Renderer::reload_changed_shaders() {
  Impl& r = *impl_;
  if (!r.watch.changed()) return std::nullopt;
  try {
    r.passes = std::make_unique<Passes>(r.gl, r.shaders, r.settings, r.typesetter);
    return "shaders reloaded";
  } catch (const InputError& error) {
    return std::string(error.what()) + "\nthe changed shaders are invalid: the old shaders are kept";
  }
}

void Renderer::finish() {
  impl_->gl.Finish();
}

std::size_t Renderer::hidden() const {
  return impl_->passes->occlusion ? impl_->passes->occlusion->hidden() : 0;
}

void Renderer::copy_to(unsigned texture) {
  impl_->passes->target.copy_to(texture);
}

Image Renderer::read_pixels() {
  return impl_->passes->target.read();
}

}  // namespace prosector
