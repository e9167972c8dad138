#pragma once
// Incremental update of a piece after a cut or an undo, bitwise equal to a full rebuild.

#include <optional>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Updates a soft body incrementally after a cut of one piece that severed nothing. Returns false, and
/// changes nothing, if the cut was of another kind or the update is impossible. All operations that can fail
/// come first.
bool follow_cut(State& state, organs::Organ& organ, TopologyCause cause, ParticipantId author,
                StepReport& report);

/// Data for updating the solver and surface of a piece incrementally after a cut.
struct Following {
  organs::PieceEdit edit;
  std::optional<SurfaceEdit> surface;  // none: the surface is replaced completely by `skin`
  organs::PieceSurface skin;
  std::optional<Anatomy> sheet;  // a sheet's complete geometry
  Numbering numbering;
};

/// Returns the data for updating a piece incrementally by the organ's changes since the state `then`. Returns
/// none if the piece must be rebuilt instead.
std::optional<Following> following_since(const Bodies& bodies, const organs::Organ& organ,
                                         const organs::Regrouped& then, const organs::OrganPiece& piece);
void take_solver_along(Bodies& bodies, Following& following);
/// Updates a body's surface for contacts after its solver was updated incrementally by the same change.
void take_surface_along(Bodies& bodies, const Following& following);

}  // namespace prosector
