#pragma once
// Shapes of an avatar: head with cap and mask, shoulders, forearm with cuff.

#include <memory>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// Surfaces of an avatar except its hands, m. Head, cap, mask and bust are in the frame of the eyes (−z
/// ahead, +y up), the bust for a level head. The forearm is in the wrist's frame, with its elbow towards +z.
struct FigureSurfaces {
  TriangleMesh head, cap, mask, bust, forearm;
};

/// Computes the surfaces of an avatar's head, cap, mask, bust and forearm. Takes some tenths of a second.
FigureSurfaces make_figure_surfaces();

/// Returns the pose of an avatar's bust below its head, whose pose is that of the eyes. The bust is upright,
/// yaws with the head and meets it at the neck.
Pose bust_below(const Pose& head);

/// Returns the pose of an avatar's forearm behind a wrist. It points from the wrist towards the bust's
/// shoulder on the side of `hand` (left_hand or right_hand), within the wrist's range of motion.
Pose forearm_behind(const Pose& wrist, const Pose& bust, std::size_t hand);

}  // namespace prosector
