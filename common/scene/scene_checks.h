#pragma once
// Checks across several fields: names, the scene graph, valid combinations of keys.

#include <map>
#include <string>

#include "common/scene/scene.h"

namespace prosector {

/// Source line of each table and key in the scene file: "soft[0]", "soft[0].parent", "soft[0].attach[1]".
class SourceLines {
 public:
  void set(const std::string& path, int line) { lines_[path] = line; }
  /// Returns the line of the key, or of its table if the key is not given.
  int of(const std::string& table, const std::string& key) const;
  /// Returns whether the key is given.
  bool has(const std::string& table, const std::string& key) const;

 private:
  std::map<std::string, int> lines_;
};

/// Sets SoftDesc::fixed of all bodies from the keys that are given.
void set_fixed_choices(SceneDesc& scene, const SourceLines& lines);

/// Throws InputError if names of bodies clash, a parent is unknown, the parents form a cycle, or a direction
/// is zero. Also throws if a body has no geometry or two, or mixes `accuracy` or `budget` with an
/// incompatible configuration.
void check_scene(const SceneDesc& scene, const SourceLines& lines);

}  // namespace prosector
