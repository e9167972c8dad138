#pragma once
// A client that receives messages from a test, and its pictures.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "client/render/projection.h"
#include "client/view/camera.h"
#include "client/view/scene_view.h"
#include "common/asset.h"
#include "common/surface_patch.h"
#include "tests/client/picture.h"

namespace prosector::test {

inline SceneBody body_of(const std::string& name, const Vec3& at, const Asset& mesh) {
  SceneBody body;
  body.name = name;
  body.pose.p = at;
  body.mesh = mesh.hash;
  return body;
}

inline PartDesc solid(const std::string& shape, const Vec3& size) {
  PartDesc part;
  part.shape = shape;
  part.size = size;
  return part;
}

/// A client with the messages that it received, and the pictures that it draws of them.
class Client {
 public:
  Client() {
    const std::vector<PartDesc> solids = {solid("box", {0.9, 0.04, 0.9}), solid("box", {0.1, 0.04, 0.1}),
                                          solid("sphere", {0.2, 0.2, 0.2})};
    for (const PartDesc& part : solids) meshes_.push_back(encode(mesh_of(part)));
    scene.bodies = {body_of("table", {0, 0.98, 0}, meshes_[0]), body_of("lamp", {-0.25, 2, 0}, meshes_[1]),
                    body_of("part", {0, 1.2, 0}, meshes_[2])};
    scene.bodies[1].moves = true;
    scene.camera = {{0, 1.8, 0.8}, {0, 1, 0}, 0.9};
  }

  /// A square of two triangles on streamed corners, stretched along x by a factor, whose figures the scene
  /// asks for.
  BodyId add_soft(const std::string& name, float stretch = 1) {
    const std::vector<Vec3> corners = {{0, 1.1, 0}, {0.2, 1.1, 0}, {0.2, 1.3, 0}, {0, 1.3, 0}};
    StreamedSurface streamed{corners, {}};
    for (std::uint32_t v = 0; v < 4; ++v) streamed.map.rows.push_back({{v}, {1}});
    const TriangleMesh surface{corners, {{0, 1, 2}, {0, 2, 3}}};
    meshes_.push_back(encode(surface));
    SceneBody body = body_of(name, Vec3::Zero(), meshes_.back());
    meshes_.push_back(encode(streamed));
    body.kind = BodyKind::soft;
    body.map = meshes_.back().hash;
    body.points = 4;
    body.chunk_points = 4;
    body.show_figures = true;
    scene.bodies.push_back(body);
    const auto id = static_cast<BodyId>(scene.bodies.size() - 1);
    TopologyRevision whole;
    whole.body = id;
    whole.mesh = body.mesh;
    whole.map = body.map;
    whole.surface_hash = hash(rounded(surface, streamed));
    whole.chain_hash = chain_hash_of(whole);
    first_states_.push_back(whole);
    Settled settled{.body = id, .time = {0, 1}, .revision = 0, .hash = 0, .positions = {}};
    for (const Vec3& x : corners)
      settled.positions.push_back(x.cast<float>().cwiseProduct(Eigen::Vector3f(stretch, 1, 1)));
    first_states_.push_back(settled);
    return id;
  }

  void tell(const Message& message) { replica_.apply({message, Liveness::alive, 1, 1}); }

  /// After the scene is as it should be.
  void join() {
    tell(SessionInfo{});
    tell(scene);
    for (const Asset& a : meshes_)
      tell(AssetChunk{a.hash, 0, 1, static_cast<std::uint32_t>(a.bytes.size()), a.bytes});
    for (const Message& message : first_states_) tell(message);
    ASSERT_TRUE(replica_.complete()) << replica_.missing();
  }

  const DrawList& list(double tick, const ViewSettings& settings, const LocalUser& self = {}) {
    return view_.build(replica_, tick, self, settings);
  }
  Image picture(double tick, const ViewSettings& settings, const LocalUser& self = {}) {
    if (!renderer_) {
      context_ = make_offscreen_context(settings.width, settings.height);
      renderer_ = std::make_unique<Renderer>(*context_, default_shader_dir());
    }
    renderer_->draw(list(tick, settings, self));
    return renderer_->read_pixels();
  }

  SceneView& view() { return view_; }

  SceneInfo scene;

 private:
  std::vector<Asset> meshes_;
  std::vector<Message> first_states_;  // of soft bodies
  Replica replica_;
  SceneView view_;
  std::unique_ptr<GlContext> context_;  // of the first picture's size
  std::unique_ptr<Renderer> renderer_;
};

inline ViewSettings plain(int width, int height) {
  ViewSettings settings;
  settings.width = width;
  settings.height = height;
  settings.overlay = false;
  return settings;
}

inline constexpr BodyId lamp_body = 1, part_body = 2;

/// Mean luminance of 5 × 5 pixels around a point of the room.
inline double brightness(const Image& image, const DrawCamera& camera, const Vec3& point) {
  const Eigen::Vector4d clip = view_projection_of(camera) * point.homogeneous();
  const int x = static_cast<int>((clip.x() / clip.w() + 1) / 2 * image.width);
  const int y = static_cast<int>((1 - clip.y() / clip.w()) / 2 * image.height);
  double sum = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) sum += luminance(image.pixel(x + dx, y + dy));
  return sum / 25;
}

inline RosterEntry ada_entry() {
  RosterEntry ada;
  ada.participant = 5;
  ada.name = "ada";
  return ada;
}

}  // namespace prosector::test
