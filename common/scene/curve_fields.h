#pragma once
// Field tables of curves and surface patches. Private to common/scene.

#include "common/scene/scene_fields.h"

namespace prosector {

/// Returns the table of scene keys for rigid bodies' curves (tubes). rigid_patch_table() returns that for
/// their surface patches (slabs).
const Table& rigid_curve_table();
const Table& rigid_patch_table();
/// Returns the table of scene keys for soft bodies' curves (the line of a rope). soft_patch_table() returns
/// that for their surface patches (the surface of a sheet).
const Table& soft_curve_table();
const Table& soft_patch_table();

}  // namespace prosector
