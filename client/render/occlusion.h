#pragma once
// Occlusion culling by hardware queries: an item is skipped if its bounding box would not pass the depth
// test. The test uses the current depth buffer, so no visible item is ever omitted. Waiting for a query has a
// cost. So only items with many triangles that seem covered are tested, and items that were visible are
// tested rarely (compare Bittner et al., Coherent hierarchical culling, Comput. Graph. Forum 23, 2004).
// Private to client/render.

#include <filesystem>
#include <map>
#include <vector>

#include "client/render/draw_queue.h"
#include "client/render/shader_program.h"

namespace prosector {

class Occlusion {
 public:
  Occlusion(const Gl& gl, const std::filesystem::path& shaders);
  ~Occlusion();
  Occlusion(const Occlusion&) = delete;
  Occlusion& operator=(const Occlusion&) = delete;

  void begin_picture() { hidden_ = 0; }
  /// Returns the number of items that were culled as occluded since begin_picture(), for all cameras
  /// together.
  std::size_t hidden() const { return hidden_; }

  /// Removes from `solids`, sorted nearest first, the items that may be occluded and have enough triangles to
  /// be worth a query, and returns them. The caller draws the remaining items, then those of the returned
  /// list that shown() reports as visible.
  std::vector<const QueuedItem*> take_query_candidates(const DrawCamera& camera,
                                                       std::vector<const QueuedItem*>& solids);
  /// Returns those of `covered` whose bounding boxes are visible over the current depth buffer, by hardware
  /// occlusion queries. The viewport must be set. Afterwards depth and colour writes and face culling are on.
  std::vector<const QueuedItem*> shown(const DrawCamera& camera,
                                       const std::vector<const QueuedItem*>& covered);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  GLuint box_ = 0, vertices_ = 0;
  std::size_t hidden_ = 0;
  std::vector<GLuint> queries_;
  std::map<std::uint64_t, int>
      frames_since_visible_;  // by mesh that was visible: frames until its next query

  void draw_box(const DrawCamera& camera, const QueuedItem& queued) const;
};

}  // namespace prosector
