#include "client/view/see_through.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "client/view/overlay_frame.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr double paper_albedo = 0.83;  // reflectance of the paper that a board is printed on
constexpr double ceiling_share = 1.9;  // factor of the ambient light on surfaces that face the ceiling
constexpr double plane_side = 1.5;     // m

// The curve of tone_map() in shaders/color.glsl.
constexpr double exposure = 0.9, toe = 0.137, shoulder = 0.321;

double tone_mapped(double radiance) {
  const double x = exposure * radiance;
  return x * (x + toe) / (x * (x + shoulder) + toe);
}

double radiance_of(double shown) {
  const double y = std::min(shown, 0.95);
  const double half = toe - shoulder * y;
  return 2 * toe * y / (half + std::sqrt(half * half + 4 * toe * y * (1 - y))) / exposure;
}

Vec3 light_from(const LightInfo& light, const Vec3& place, const Vec3& normal) {
  const Vec3 all = light.intensity * light.color;
  if (light.kind == LightKind::directional)
    return all * std::max(0.0, -normal.dot(light.direction.normalized()));
  const Vec3 way = light.position - place;
  const double squared = std::max(way.squaredNorm(), 1e-4);
  const Vec3 towards = way / std::sqrt(squared);
  double share = std::max(0.0, normal.dot(towards)) / squared;
  if (light.kind == LightKind::spot) {
    const double rim = std::cos(light.cone);
    const double core = std::cos(light.cone * (1 - std::clamp(light.softness, 0.001, 1.0)));
    const double t = std::clamp((-towards.dot(light.direction.normalized()) - rim) / (core - rim), 0.0, 1.0);
    share *= t * t * (3 - 2 * t);
  }
  return share * all;
}

/// Returns the scene's body with this name. Throws InputError with the list of the scene's bodies if there is
/// none.
const SceneBody& body_called(const SceneInfo& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.bodies, name, &SceneBody::name);
  if (found != scene.bodies.end()) return *found;
  std::vector<std::string> known;
  for (const SceneBody& body : scene.bodies) known.push_back(body.name);
  throw InputError(fmt::format("phantom \"{}\": the scene \"{}\" has no such body; bodies: {}", name,
                               scene.name, fmt::join(known, ", ")));
}

}  // namespace

void check_phantoms(const SceneInfo& scene, std::span<const std::string> names, const std::string& found) {
  for (const std::string& name : names) (void)body_called(scene, name);
  if (!found.empty() && body_called(scene, found).kind != BodyKind::rigid)
    throw InputError(
        fmt::format("phantom.body {}: must be a rigid body; for a soft one use --phantom", found));
}

Vec3 rendered_paper_color(const DrawList& list, const Vec3& place, const Vec3& normal) {
  Vec3 light = ceiling_share * list.ambient;
  for (const LightInfo& one : list.lights) light += light_from(one, place, normal);
  return (paper_albedo * light).unaryExpr(&tone_mapped);
}

void match_lighting(DrawItem& item, const Vec3& shown, const Vec3& paper) {
  constexpr double least = 0.02, most = 4;             // factor of brightness
  constexpr double least_tint = 0.6, most_tint = 1.6;  // factor of one colour channel relative to the mean
  const Vec3 ratio =
      paper.unaryExpr(&radiance_of).cwiseQuotient(shown.unaryExpr(&radiance_of).cwiseMax(1e-3));
  const double grey = std::clamp(ratio.mean(), least, most);
  item.brightness *= grey;
  item.appearance.color = item.appearance.color.cwiseProduct(
      (ratio / std::max(ratio.mean(), 1e-6)).cwiseMax(least_tint).cwiseMin(most_tint));
}

DrawItem table_plane(const Pose& room_board, std::uint64_t mesh_id) {
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = mesh_id;
  const float half = plane_side / 2;
  mesh->positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh->normals.assign(4, Eigen::Vector3f::UnitZ());
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return {
      .mesh = mesh, .pose = room_board, .appearance = {}, .casts_shadow = false, .showing = ItemRole::ground};
}

void add_centred_text(DrawList& list, const std::string& words) {
  if (words.empty()) return;
  constexpr double height = 16, border = 40;  // points
  const OverlayFrame frame(list);
  list.texts.push_back({.text = words,
                        .at = {frame.width / 2, frame.height / 2, 0},
                        .height = height,
                        .wrap = frame.width - 2 * border,
                        .centred = true,
                        .ground = TextGround::framed});
}

}  // namespace prosector
