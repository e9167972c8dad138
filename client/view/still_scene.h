#pragma once
// A scene file as a draw list, without a session: every body at its initial pose.

#include "client/view/draw_list.h"
#include "common/anatomy/sources.h"

namespace prosector {

/// Returns a draw list with room, bodies and lights of a scene file, every body at its initial pose. The
/// caller adds cameras. Meshing reports its progress through `progress`. Throws InputError for scenes that
/// the server rejects.
DrawList still_scene(const SceneDesc& scene, const SourcePaths& paths, const Progress& progress);

}  // namespace prosector
