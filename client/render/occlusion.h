#pragma once
// What other things hide is not drawn: where a box around it would show nothing over the depth of what is
// drawn already, it would not either. The picture itself is asked, so nothing that shows is ever left out.
// Waiting for the answer costs. So it is asked only of what has many triangles and seems covered, and seldom
// of what was seen (compare Bittner et al., Coherent hierarchical culling, Comput. Graph. Forum 23, 2004).
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
  /// Returns how many were hidden since then, for all cameras together.
  std::size_t hidden() const { return hidden_; }

  /// Moves those of `solids`, nearest first, that may be hidden and are worth asking about to a list of their
  /// own. The caller draws what is left, then what shown() gives of these.
  std::vector<const QueuedItem*> take_covered(const DrawCamera& camera,
                                              std::vector<const QueuedItem*>& solids);
  /// Returns those of `covered` that show over the depth that is drawn already, with the viewport set.
  /// Changes depth and colour masks back to writing, and the culling of faces to on.
  std::vector<const QueuedItem*> shown(const DrawCamera& camera,
                                       const std::vector<const QueuedItem*>& covered);

 private:
  const Gl& gl_;
  ShaderProgram program_;
  GLuint box_ = 0, vertices_ = 0;
  std::size_t hidden_ = 0;
  std::vector<GLuint> queries_;
  std::map<std::uint64_t, int> pictures_seen_;  // by mesh: since the answer was last that it shows

  void draw_box(const DrawCamera& camera, const QueuedItem& queued) const;
};

}  // namespace prosector
