#pragma once
// The shape of a person: head with cap and mask, shoulders, forearm with cuff.

#include <memory>

#include "client/view/draw_list.h"
#include "common/mesh.h"

namespace prosector {

/// What of a person is not a hand, in metres. Head, cap, mask and bust are about the eyes, −z ahead and
/// +y up, the bust as of a head held level. The forearm is in a wrist's frame, its elbow towards +z.
struct FigureSurfaces {
  TriangleMesh head, cap, mask, bust, forearm;
};

/// Makes the surfaces. Takes some tenths of a second.
FigureSurfaces make_figure_surfaces();

/// Returns the pose of the bust below a head: it stands upright, turns with the head and meets it at the
/// neck.
Pose bust_below(const Pose& head);

/// Returns the pose of the forearm behind a wrist: its elbow is bent towards the shoulder of the bust on that
/// side (left_hand, right_hand), as far as a wrist bends.
Pose forearm_behind(const Pose& wrist, const Pose& bust, std::size_t hand);

}  // namespace prosector
