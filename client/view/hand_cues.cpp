#include "client/view/hand_cues.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr std::size_t sides = 24;
constexpr double shadow_radius = 0.03, ring_radius = 0.012;  // m
constexpr double farthest = 1;                               // m: no cues for surfaces farther below
// m: height of the rays' origins, because fingertips may be below the surface.
constexpr double from_above = 0.03;
constexpr double steepest_step = 0.03;               // m: largest height difference within the shadow
constexpr double lift = 0.0015;                      // m, off the surface
constexpr double darkest = 0.55, fades_over = 0.12;  // opacity at contact; m over which it falls to a tenth
const Vec3 line_color{0.85, 0.9, 0.95};

/// Returns the point on the body below or above a point at `radius` from the centre, at an angle given by
/// `side`.
Vec3 draped(const Vec3& middle, double radius, std::size_t side, const FindSurface& find, BodyId body) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(side) / sides;
  const Vec3 beside = middle + radius * Vec3(std::cos(angle), 0, -std::sin(angle));
  const auto point = find({beside + steepest_step * Vec3::UnitY(), -Vec3::UnitY()}, body);
  if (!point || point->distance > 2 * steepest_step) return beside + lift * Vec3::UnitY();
  return point->at + lift * point->normal;
}

}  // namespace

void HandCues::make_meshes(std::uint64_t& next_mesh_id) {
  for (auto& mesh : shadow_) {
    mesh = std::make_shared<DrawMesh>();
    mesh->id = next_mesh_id++;
    mesh->positions.resize(2 * sides);
    mesh->normals.assign(2 * sides, Eigen::Vector3f::UnitY());
    for (std::uint32_t k = 0; k < sides; ++k) {  // inner ring, then outer ring, both counter-clockwise
      const auto next = static_cast<std::uint32_t>((k + 1) % sides), out = static_cast<std::uint32_t>(sides);
      mesh->triangles.push_back({k, out + k, out + next});
      mesh->triangles.push_back({k, out + next, next});
    }
  }
}

void HandCues::add(DrawList& list, const Vec3& fingertips, const FindSurface& find,
                   std::uint64_t& next_mesh_id) {
  const auto below = find({fingertips + from_above * Vec3::UnitY(), -Vec3::UnitY()}, std::nullopt);
  if (!below || below->distance > farthest) return;
  if (!shadow_[0]) make_meshes(next_mesh_id);
  const double height = std::max(below->distance - from_above, 0.0);
  const auto around = [&](double radius) {
    std::array<Vec3, sides> out;
    for (std::size_t k = 0; k < sides; ++k) out[k] = draped(below->at, radius, k, find, below->body);
    return out;
  };
  std::array<Vec3, sides> inner = around(0.001);
  for (std::size_t band = 0; band < bands; ++band) {
    const std::array<Vec3, sides> outer = around(shadow_radius * static_cast<double>(band + 1) / bands);
    DrawMesh& mesh = *shadow_[band];
    for (std::size_t k = 0; k < sides; ++k) {
      mesh.positions[k] = inner[k].cast<float>();
      mesh.positions[sides + k] = outer[k].cast<float>();
    }
    ++mesh.positions_revision;
    // Fraction of the distance from the centre to the rim.
    const double out = (static_cast<double>(band) + 0.5) / bands;
    list.items.push_back(
        {.mesh = shadow_[band],
         .pose = {},
         .appearance = {.color = Vec3::Zero(), .roughness = 1},
         .casts_shadow = false,
         .opacity = darkest * std::exp(-2.5 * out * out) * std::exp(-2.3 * height / fades_over)});
    inner = outer;
  }
  const std::array<Vec3, sides> ring = around(ring_radius);
  for (std::size_t k = 0; k < sides; ++k)
    list.lines.push_back({ring[k], ring[(k + 1) % sides], line_color, 1.5, false});
  list.lines.push_back({fingertips, below->at, line_color, 1.5, false});
}

}  // namespace prosector
