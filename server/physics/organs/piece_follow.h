#pragma once
// What hangs on a piece's mesh follows a cut, or what takes one back, to the bits that it would have if it
// were made anew.

#include <optional>

#include "server/physics/organs/organ.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Lets a body follow where one piece was cut and nothing came off it. Returns false, and changes nothing,
/// where that isn't so or can't be followed. What can fail fails first.
bool follow_cut(State& state, Organ& organ, TopologyCause cause, ParticipantId author, StepReport& report);

/// What a piece's solver and its surface, which are there, follow.
struct Following {
  PieceEdit edit;
  std::optional<SurfaceEdit> surface;  // none: it becomes another altogether, which is
  PieceSurface skin;
  std::optional<Anatomy> sheet;  // a sheet's geometry, which is made whole
  Numbering numbering;
};

/// Returns how a piece follows the changes since `then`; none where it has to be made anew.
std::optional<Following> following_since(const Bodies& bodies, const Organ& organ, const Regrouped& then,
                                         const OrganPiece& piece);
void take_solver_along(Bodies& bodies, Following& following);
/// Takes the body's surface along with the change; called after the solver.
void take_surface_along(Bodies& bodies, const Following& following);

}  // namespace prosector
