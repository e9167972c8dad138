#pragma once
// Access to the keys that rigid and soft bodies share, for functions of both. A RigidDesc stores them itself,
// a SoftDesc in its groups.

#include <type_traits>

#include "common/scene/scene.h"

namespace prosector {

template <class Desc>
inline constexpr bool is_soft_desc = std::is_same_v<std::remove_const_t<Desc>, SoftDesc>;

/// Returns the struct of a RigidDesc or SoftDesc that stores its source file's keys: volume, label, mesh …
template <class Desc>
auto& geometry_of(Desc& desc) {
  if constexpr (is_soft_desc<Desc>)
    return desc.geometry;
  else
    return desc;
}

/// Returns the struct of a RigidDesc or SoftDesc that stores its density (kg/m³).
template <class Desc>
auto& material_of(Desc& desc) {
  if constexpr (is_soft_desc<Desc>)
    return desc.material;
  else
    return desc;
}

/// Returns the struct of a RigidDesc or SoftDesc that stores its collision shape, collision groups and
/// friction.
template <class Desc>
auto& contact_of(Desc& desc) {
  if constexpr (is_soft_desc<Desc>)
    return desc.contact;
  else
    return desc;
}

}  // namespace prosector
