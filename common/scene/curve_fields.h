#pragma once
// The tables of curves and of pieces of surfaces. Private to common/scene.

#include "common/scene/scene_fields.h"

namespace prosector {

/// Returns the tables of rigid bodies, which are tubes around curves and slabs over patches.
const Table& rigid_curve_table();
const Table& rigid_patch_table();
/// Returns the tables of soft bodies: what a rope or a sheet is laid along.
const Table& soft_curve_table();
const Table& soft_patch_table();

}  // namespace prosector
