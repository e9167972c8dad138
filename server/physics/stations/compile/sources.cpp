#include "server/physics/stations/compile/sources.h"

#include "common/anatomy/atlas.h"
#include "common/anatomy/sources.h"
#include "server/physics/stations/compile/grading.h"

namespace prosector {
namespace {

SourcePaths paths_of(const SceneDesc& scene, const CompileOptions& options) {
  return {scene.file.parent_path(), options.data_dirs, options.cache_dir};
}

}  // namespace

SceneDesc whole_scene(const SceneDesc& scene, const CompileOptions& options) {
  return completed(scene, paths_of(scene, options), options.progress);
}

TriangleMesh rigid_surface(const RigidDesc& desc, const SceneDesc& scene, const CompileOptions& options) {
  return make_surface(desc, paths_of(scene, options), options.progress);
}

Anatomy soft_anatomy(const SoftDesc& desc, const SceneDesc& scene, const CompileOptions& options) {
  std::optional<Anatomy> made;
  if (options.anatomy) made = options.anatomy(desc);
  if (!made) made = make_anatomy(desc, paths_of(scene, options), options.progress);
  return desc.geometry.grade == Grading::rims ? graded_at_rims(desc, std::move(*made)) : std::move(*made);
}

}  // namespace prosector
