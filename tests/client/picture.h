#pragma once
// Small scenes for the picture tests, and how to draw them.

#include <functional>
#include <memory>

#include "client/render/renderer.h"
#include "common/scene/primitives.h"

namespace prosector::test {

using MakeContext = std::unique_ptr<GlContext> (*)(int width, int height);

inline Image picture_of(const DrawList& list, int width, int height,
                        MakeContext make = make_offscreen_context, const RendererSettings& settings = {}) {
  const auto context = make(width, height);
  Renderer renderer(*context, default_shader_dir(), settings);
  renderer.draw(list);
  return renderer.read_pixels();
}

/// A sphere about the origin with exact normals.
inline std::shared_ptr<DrawMesh> sphere_mesh(double radius, std::uint64_t id) {
  PartDesc part;
  part.shape = "sphere";
  part.size = Vec3::Constant(2 * radius);
  const TriangleMesh mesh = mesh_of(part);
  auto out = std::make_shared<DrawMesh>();
  out->id = id;
  for (const Vec3& x : mesh.positions) {
    out->positions.push_back(x.cast<float>());
    out->normals.push_back(x.normalized().cast<float>());
  }
  out->triangles = mesh.triangles;
  return out;
}

/// A camera at `eye` that looks along −z, with square pixels.
inline DrawCamera straight_camera(const Vec3& eye, int width, int height, double half_height = 0.4) {
  DrawCamera camera;
  camera.pose.p = eye;
  camera.top = half_height;
  camera.bottom = -half_height;
  camera.right = half_height * width / height;
  camera.left = -camera.right;
  camera.width = width;
  camera.height = height;
  return camera;
}

inline LightInfo directional(const Vec3& direction) {
  LightInfo light;
  light.kind = LightKind::directional;
  light.direction = direction.normalized();
  return light;
}

inline LightInfo lamp(const Vec3& at, const Vec3& target) {
  LightInfo light;
  light.kind = LightKind::spot;
  light.position = at;
  light.direction = (target - at).normalized();
  light.intensity = 1.4 * (target - at).squaredNorm();
  light.cone = 0.5;
  light.softness = 0.4;
  return light;
}

inline double luminance(const std::uint8_t* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

}  // namespace prosector::test
