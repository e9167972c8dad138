#include "client/render/main_pass.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "client/render/effects.h"
#include "client/render/main_uniforms.h"

namespace prosector {
namespace {

/// Returns whether the eye or its near plane may be inside the body, which then shows its inner faces.
bool may_contain_eye(const Vec3& eye, const QueuedItem& queued) {
  const Surface surface = queued.item->appearance.surface;
  return (surface == Surface::tissue || surface == Surface::bone) &&
         (eye - queued.bounds.center).norm() <= queued.bounds.radius;
}

/// Returns whether the sphere is so small on the screen that it almost never covers a pixel's centre.
bool is_subpixel(const DrawCamera& camera, const Sphere& sphere) {
  constexpr double least = 0.5;  // pixels across
  const double pixels_per_tangent = camera.height / (camera.top - camera.bottom);
  const double distance = (sphere.center - camera.pose.p).norm() - sphere.radius;
  return distance > 0 && 2 * sphere.radius / distance * pixels_per_tangent < least;
}

bool is_transparent(const DrawItem& item) {
  return item.opacity < 1;
}

}  // namespace

bool is_glass(const DrawItem& item) {
  return item.appearance.surface == Surface::glass && !item.painted && !item.shaft && item.opacity >= 1;
}

struct MainPass::Frame {
  const DrawList& list;
  const DrawCamera& camera;
  const MeshCache& meshes;
  const Shadow& shadow;
  const Environment& environment;
  bool refracts = false;  // glass is drawn by draw_glass() over the frame
  std::map<std::tuple<Surface, bool, bool, bool, bool, bool, bool, unsigned long>, const ShaderProgram*>
      found = {};
  std::set<const ShaderProgram*> set_up = {};
};

MainPass::MainPass(const Gl& gl, const std::filesystem::path& shaders, std::vector<std::string> defines)
    : gl_(gl),
      shaders_(shaders),
      defines_(std::move(defines)),
      refracts_(std::ranges::count(defines_, effect_rows[index_of(Effect::refraction)].define) > 0),
      probes_(std::ranges::count(defines_, "PROBE") > 0) {}

void MainPass::compile_all() {
  for (std::size_t k = 0; k <= static_cast<std::size_t>(last_surface); ++k)
    program_for(item_defines(static_cast<Surface>(k), true, light_defines(std::vector<LightInfo>(1), 1, 0)));
  Defines brushed = item_defines(Surface::metal, false, light_defines(std::vector<LightInfo>(1), 1, 0));
  brushed.push_back("BRUSHED");
  program_for(brushed);
  if (!probes_) {
    Defines ground = item_defines(Surface::plain, false, light_defines(std::vector<LightInfo>(1), 1, 0));
    ground.push_back("GROUND");
    program_for(ground);
  }
  if (!refracts_) return;
  Defines glass = item_defines(Surface::glass, false, light_defines(std::vector<LightInfo>(1), 1, 0));
  glass.push_back("REFRACTS");
  program_for(glass);
}

const ShaderProgram& MainPass::program_for(const Defines& defines) {
  auto& program = programs_[defines];
  if (!program) {
    Defines all = defines_;
    all.insert(all.end(), defines.begin(), defines.end());
    program = std::make_unique<ShaderProgram>(gl_, shaders_, "main", all);
  }
  return *program;
}

/// Binds the item's program and sets all its uniforms.
const ShaderProgram& MainPass::ready(const QueuedItem& queued, Frame& frame) {
  const DrawItem& item = *queued.item;
  const bool is_wet = item.appearance.wetness > 0;
  const LightSet lights = item.shaft || item.painted ? LightSet() : lights_of(queued, frame.list.lights);
  const bool is_ground = item.showing == ItemRole::ground;
  const ShaderProgram*& program =
      frame.found[{item.appearance.surface, is_wet, item.shaft, item.painted, is_transparent(item),
                   is_brushed(item), is_ground, lights.to_ulong()}];
  if (!program) {
    Defines defines = item_defines(item.appearance.surface, is_wet,
                                   light_defines(frame.list.lights, lights, frame.shadow.light));
    if (item.shaft) defines.push_back("SHAFT");
    if (item.painted) defines.push_back("PAINTED");
    if (is_transparent(item)) defines.push_back("CLEAR");
    if (is_brushed(item)) defines.push_back("BRUSHED");
    if (is_ground) defines.push_back("GROUND");
    if (frame.refracts) defines.push_back("REFRACTS");
    program = &program_for(defines);
  }
  program->use();
  if (frame.set_up.insert(program).second) {
    set_frame(*program, frame.list, frame.camera, frame.shadow, frame.environment);
    if (frame.refracts) set_refraction(*program, frame.camera);
  }
  set_item(*program, item);
  // Set even without a section: some drivers keep clipping in programs that clipped before.
  set_clip_plane(*program, is_opened(item, frame.list) ? clip_plane_of(*frame.list.section) : no_clip_plane);
  return *program;
}

/// Calls draw() for the item's front faces, and before for its inside if that is visible.
template <class Draw>
void MainPass::draw_sides(const QueuedItem& queued, Frame& frame, const Draw& draw) {
  const ShaderProgram& program = ready(queued, frame);
  const DrawItem& item = *queued.item;
  const bool mirrored = item.shape.A.determinant() < 0;
  const bool opened = is_opened(item, frame.list);
  if (item.seen_from_inside || opened || may_contain_eye(frame.camera.pose.p, queued)) {
    const Eigen::Matrix4d normals = matrix_of(normal_map(item));
    program.set("room_from_normal", Eigen::Matrix4d(-normals));
    gl_.CullFace(mirrored ? GL_BACK : GL_FRONT);
    draw();
    program.set("room_from_normal", normals);
  }
  gl_.CullFace(mirrored ? GL_FRONT : GL_BACK);
  draw();
  gl_.CullFace(GL_BACK);
}

void MainPass::bind_shadow(GLuint texture) const {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, texture);
}

void MainPass::draw_solid(const QueuedItem& queued, Frame& frame) {
  draw_sides(queued, frame, [&] { prosector::draw(frame.meshes, queued); });
}

/// Draws a transparent item: first its depth only, so that only the front of a body is visible, not its
/// inside and back.
void MainPass::draw_transparent(const QueuedItem& queued, Frame& frame) {
  draw_sides(queued, frame, [&] {
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    prosector::draw(frame.meshes, queued);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Enable(GL_BLEND);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    prosector::draw(frame.meshes, queued);
    gl_.Disable(GL_BLEND);
    gl_.DepthFunc(GL_LESS);
  });
}

/// Draws ground: first the depth of all ground items, then the shadows as a factor of the light.
void MainPass::draw_ground(const std::vector<const QueuedItem*>& grounds, Frame& frame) {
  const auto draw_all = [&] {
    for (const QueuedItem* queued : grounds) {
      ready(*queued, frame);
      gl_.CullFace(queued->item->shape.A.determinant() < 0 ? GL_FRONT : GL_BACK);
      prosector::draw(frame.meshes, *queued);
    }
  };
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_all();
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ZERO, GL_SRC_COLOR);
  draw_all();
  gl_.Disable(GL_BLEND);
  gl_.DepthFunc(GL_LESS);
  gl_.CullFace(GL_BACK);
}

/// Draws glass without refraction: the background, attenuated by reflection and absorption.
void MainPass::draw_unrefracted_glass(const QueuedItem& queued, Frame& frame) {
  ready(queued, frame);
  gl_.CullFace(queued.item->shape.A.determinant() < 0 ? GL_FRONT : GL_BACK);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
  prosector::draw(frame.meshes, queued);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
  gl_.CullFace(GL_BACK);
}

void MainPass::draw_shaft(const QueuedItem& queued, Frame& frame) {
  ready(queued, frame);
  gl_.DepthMask(GL_FALSE);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE);
  prosector::draw(frame.meshes, queued);
  gl_.Disable(GL_BLEND);
  gl_.DepthMask(GL_TRUE);
}

void MainPass::draw(const DrawList& list, const DrawCamera& camera, const std::vector<QueuedItem>& items,
                    const MeshCache& meshes, const Shadow& shadow, const Environment& environment,
                    Occlusion* occlusion) {
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
  gl_.Enable(GL_CULL_FACE);
  gl_.CullFace(GL_BACK);
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment.cube);
  bind_shadow(shadow.texture);
  if (list.section) gl_.Enable(GL_CLIP_DISTANCE0);
  const Frustum frustum(view_projection_of(camera));
  Frame frame{list, camera, meshes, shadow, environment};
  std::vector<const QueuedItem*> grounds, solids, clear, shafts;
  for (const QueuedItem& queued : items) {
    if (!frustum.may_see(queued.bounds) || is_subpixel(camera, queued.bounds)) continue;
    if (queued.item->showing == ItemRole::around && !probes_) continue;
    if (queued.item->showing == ItemRole::real) continue;
    if (queued.item->showing == ItemRole::ground)
      grounds.push_back(&queued);
    else if (queued.item->shaft)
      shafts.push_back(&queued);
    else if (is_glass(*queued.item) && refracts_ && !camera.inset)
      continue;
    else if (is_transparent(*queued.item) || is_glass(*queued.item))
      clear.push_back(&queued);
    else
      solids.push_back(&queued);
  }
  if (!grounds.empty()) {
    bind_shadow(shadow.on_ground);
    draw_ground(grounds, frame);
    bind_shadow(shadow.texture);
  }
  std::vector<const QueuedItem*> covered;
  if (occlusion != nullptr) covered = occlusion->take_query_candidates(camera, solids);
  for (const QueuedItem* queued : solids) draw_solid(*queued, frame);
  if (!covered.empty())
    for (const QueuedItem* queued : occlusion->shown(camera, covered)) draw_solid(*queued, frame);
  for (auto queued = clear.rbegin(); queued != clear.rend(); ++queued)
    is_glass(*(*queued)->item) ? draw_unrefracted_glass(**queued, frame) : draw_transparent(**queued, frame);
  for (const QueuedItem* queued : shafts) draw_shaft(*queued, frame);
  gl_.Disable(GL_CLIP_DISTANCE0);
  gl_.Disable(GL_CULL_FACE);
}

void MainPass::draw_glass(const DrawList& list, const DrawCamera& camera,
                          const std::vector<const QueuedItem*>& glass, const MeshCache& meshes,
                          const Shadow& shadow, const Environment& environment, const Refraction& seen) {
  GLenum unit = GL_TEXTURE0 + first_glass_unit;
  for (const GLuint texture :
       {seen.picture, seen.scene_depth, seen.front_depth, seen.back_depth, seen.back_normals}) {
    gl_.ActiveTexture(unit++);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
  }
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_CUBE_MAP, environment.cube);
  bind_shadow(shadow.texture);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.Enable(GL_CULL_FACE);
  gl_.DepthMask(GL_FALSE);
  Frame frame{list, camera, meshes, shadow, environment, true};
  for (const QueuedItem* queued : glass) {
    ready(*queued, frame);
    gl_.CullFace(queued->item->shape.A.determinant() < 0 ? GL_FRONT : GL_BACK);
    prosector::draw(frame.meshes, *queued);
  }
  gl_.CullFace(GL_BACK);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace prosector
