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
  /// Returns how many items were culled since begin_picture(), for all cameras together.
  std::size_t hidden() const { return hidden_; }

  /// Moves those of `solids`, sorted nearest first, that may be hidden and are worth testing to a separate
  /// list. The caller draws the remaining ones, then those of the list that shown() returns.
  std::vector<const QueuedItem*> take_query_candidates(const DrawCamera& camera,
                                                       std::vector<const QueuedItem*>& solids);
  /// Returns those of `covered` that are visible over the current depth buffer, with the viewport set.
  /// Afterwards depth and colour writes and face culling are on.
  std::vector<const QueuedItem*> shown(const DrawCamera& camera,
                                       const std::vector<const QueuedItem*>& covered);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  GLuint box_ = 0, vertices_ = 0;
  std::size_t hidden_ = 0;
  std::vector<GLuint> queries_;
  std::map<std::uint64_t, int>
      frames_since_visible_;  // by mesh: frames since the last query that found it visible

  void draw_box(const DrawCamera& camera, const QueuedItem& queued) const;
};

}  // namespace prosector
