#pragma once
// A scene file as a picture, without a session: every body where the scene puts it.

#include "client/view/draw_list.h"
#include "common/anatomy/sources.h"

namespace prosector {

/// Makes room, bodies and lights of a scene; cameras are the caller's to add. Meshing says what it does
/// through `progress`. Throws InputError where the server would.
DrawList still_scene(const SceneDesc& scene, const SourcePaths& paths, const Progress& progress);

}  // namespace prosector
