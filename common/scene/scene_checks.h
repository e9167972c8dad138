#pragma once
// What no single field can tell: names, the scene graph, which keys go together.

#include <map>
#include <string>

#include "common/scene/scene.h"

namespace prosector {

/// Line of each table and key that the author wrote: "soft[0]", "soft[0].parent", "soft[0].attach[1]".
class SourceLines {
 public:
  void set(const std::string& path, int line) { lines_[path] = line; }
  /// Returns the key's line, or its table's where the key was not given.
  int of(const std::string& table, const std::string& key) const;
  /// Tells whether the key was given.
  bool has(const std::string& table, const std::string& key) const;

 private:
  std::map<std::string, int> lines_;
};

/// Fills SoftDesc::fixed of bodies that are chosen by need.
void note_fixed_choices(SceneDesc& scene, const SourceLines& lines);

/// Throws InputError when bodies' names clash, parents are unknown or form a cycle, or a direction is zero.
/// Throws when a body has no geometry or two, or is chosen by need and by rung.
void check_scene(const SceneDesc& scene, const SourceLines& lines);

}  // namespace prosector
