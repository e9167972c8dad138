#pragma once
// Field tables of curves and surface patches. Private to common/scene.

#include "common/scene/scene_fields.h"

namespace prosector {

/// Returns the tables of rigid bodies' curves (tubes) and patches (slabs).
const Table& rigid_curve_table();
const Table& rigid_patch_table();
/// Returns the tables of soft bodies' curves (the line of a rope) and patches (the surface of a sheet).
const Table& soft_curve_table();
const Table& soft_patch_table();

}  // namespace prosector
