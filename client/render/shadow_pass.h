#pragma once
// Shadow map of the first spot light. Static casters are cached in a separate layer, so that a frame redraws
// only moving casters, and nothing if none moves. Real objects, which cast shadows on virtual ones, have a
// separate layer. Private to client/render.

#include <filesystem>
#include <optional>
#include <vector>

#include "client/render/draw_queue.h"
#include "client/render/shader_program.h"

namespace prosector {

/// Shadow map of the first spot light, as input of the main pass: its depth textures, size and projection.
struct Shadow {
  int light = -1;  // index into DrawList::lights; −1: no shadows
  Eigen::Matrix4d clip_from_room = Eigen::Matrix4d::Identity();
  GLuint texture = 0;
  GLuint on_ground = 0;  // without real objects, because a camera image already contains their shadows
  double size = 0;       // texels, width and height
  double texel = 0;      // width of a texel at 1 m from the light, m
};

class ShadowPass {
 public:
  ShadowPass(const Gl& gl, const std::filesystem::path& shaders, int size);
  ~ShadowPass();
  ShadowPass(const ShadowPass&) = delete;
  ShadowPass& operator=(const ShadowPass&) = delete;

  Shadow draw(const DrawList& list, const std::vector<QueuedItem>& items, const MeshCache& meshes);

 private:
  struct Layer {
    GLuint framebuffer = 0, depth = 0;
  };
  /// State of a shadow caster on which its shadow depends: mesh, level of detail, pose and shape. The shadow
  /// map is redrawn when it changes.
  struct Caster {
    std::uint64_t mesh = 0, revision = 0, positions_revision = 0;
    std::size_t level = 0;
    Pose pose;
    Affine shape;
    bool operator==(const Caster& o) const {
      return mesh == o.mesh && revision == o.revision && positions_revision == o.positions_revision &&
             level == o.level && pose.p == o.pose.p && pose.q.coeffs() == o.pose.q.coeffs() &&
             shape.A == o.shape.A && shape.p == o.shape.p;
    }
  };
  using Items = std::vector<const QueuedItem*>;

  static constexpr int frames_until_still = 8;

  const Gl& gl_;
  ShaderProgram program_;
  int size_;
  Layer whole_, still_;
  std::optional<Layer> with_real_;  // whole_ with real objects; nullopt: none so far
  Eigen::Matrix4d clip_from_room_ = Eigen::Matrix4d::Zero();  // the layers were drawn with it
  std::optional<SectionPlane> section_;                       // that opened the casters in the layers
  std::vector<Caster> casters_;                               // in whole_
  std::vector<int> unchanged_;                                // by caster: frames without a change
  std::vector<bool> in_still_;                                // by caster

  Layer make_layer() const;
  /// Compares the shadow casters with those of the last frame, and updates for each the number of frames
  /// without a change. Returns false if the casters, the light's projection and the section plane are all
  /// unchanged.
  bool note_changes(const Items& items, const Eigen::Matrix4d& clip_from_room,
                    const std::optional<SectionPlane>& section);
  void draw_layers(const Items& items, const MeshCache& meshes);
  void add_real(const Items& items, const MeshCache& meshes);
  void copy(const Layer& from, const Layer& to) const;
  void draw_items(const Items& items, const MeshCache& meshes) const;
};

}  // namespace prosector
