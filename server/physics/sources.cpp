#include "server/physics/sources.h"

#include <fmt/format.h>

#include "common/error.h"
#include "common/primitives.h"

namespace prosector {

TriangleMesh rigid_surface(const RigidDesc& desc, const SceneDesc&, const CompileOptions&) {
  if (desc.parts.empty()) throw InputError(fmt::format("rigid '{}': has no parts", desc.name));
  return mesh_of(desc.parts);
}

Anatomy soft_anatomy(const SoftDesc& desc, const SceneDesc&, const CompileOptions& options) {
  if (options.anatomy)
    if (std::optional<Anatomy> given = options.anatomy(desc)) return std::move(*given);
  throw InputError(fmt::format("soft '{}': no geometry given", desc.name));
}

}  // namespace prosector
