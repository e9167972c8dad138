#pragma once
// Incremental update of a piece after a cut or an undo, bitwise equal to a full rebuild.

#include <optional>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Updates a body incrementally if one piece was cut and nothing was severed. Returns false, and changes
/// nothing, if that or the update is impossible. All operations that can fail come first.
bool follow_cut(State& state, Organ& organ, TopologyCause cause, ParticipantId author, StepReport& report);

/// Inputs for the incremental update of a piece's existing solver and surface.
struct Following {
  PieceEdit edit;
  std::optional<SurfaceEdit> surface;  // none: the surface is replaced completely by `skin`
  PieceSurface skin;
  std::optional<Anatomy> sheet;  // a sheet's complete geometry
  Numbering numbering;
};

/// Returns the update of a piece for the changes since `then`; none if it must be rebuilt.
std::optional<Following> following_since(const Bodies& bodies, const Organ& organ, const Regrouped& then,
                                         const OrganPiece& piece);
void take_solver_along(Bodies& bodies, Following& following);
/// Updates the body's surface after its solver.
void take_surface_along(Bodies& bodies, const Following& following);

}  // namespace prosector
