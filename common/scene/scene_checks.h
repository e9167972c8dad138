#pragma once
// Checks across several fields: names, the scene graph, valid combinations of keys.

#include <map>
#include <string>

#include "common/scene/scene.h"

namespace prosector {

/// Source lines of the tables and keys in a scene file, by path, such as "soft[0]", "soft[0].parent" or
/// "soft[0].attach[1]".
class SourceLines {
 public:
  void set(const std::string& path, int line) { lines_[path] = line; }
  /// Returns the line of the scene file at which the table's key is given. Returns that of the table if the
  /// key is not given.
  int of(const std::string& table, const std::string& key) const;
  /// Returns whether the scene file gives the table's key.
  bool has(const std::string& table, const std::string& key) const;

 private:
  std::map<std::string, int> lines_;
};

/// Sets, for each soft body, which properties of its model configuration the author fixed (SoftDesc::fixed),
/// from the keys that the scene file gives.
void set_fixed_choices(SceneDesc& scene, const SourceLines& lines);

/// Checks a scene across several keys; `lines` provides the positions for messages. Throws InputError if
/// names of bodies clash, a parent is unknown, the parents form a cycle, or a direction is zero. Also throws
/// if a body has no geometry or two, or mixes `accuracy` or `budget` with an incompatible configuration.
void check_scene(const SceneDesc& scene, const SourceLines& lines);

}  // namespace prosector
