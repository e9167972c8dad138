#pragma once
// Creates and updates the bodies of an organ's pieces after a change.

#include <memory>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Creates and updates the bodies of an organ's pieces after a change. Throws, and changes nothing, if that
/// is impossible.
void remake(State& state, Organ& organ, TopologyCause cause, ParticipantId author, StepReport& report);

/// Returns a solver with a body's tissue properties and another geometry.
std::unique_ptr<SoftBody> same_tissue(const Bodies& bodies, std::size_t body, SoftDesc desc, Anatomy anatomy);
/// Returns the solver of a piece, with the organ's material and a name derived from the organ. Fills
/// `numbering`.
std::unique_ptr<SoftBody> make_piece(const Bodies& bodies, const Organ& organ, std::size_t body,
                                     Numbering& numbering);
/// Replaces the body's solver, at rest; or appends a body if it is new. `first`: the organ's original soft
/// body. `surface`: of the solver's anatomy.
void place_piece(State& state, std::size_t body, std::size_t first, std::unique_ptr<SoftBody> solver,
                 Numbering numbering, TissueSurface surface);

// ---- Also used by incremental updates after a cut (piece_follow.cpp)
/// Sets a piece's motion and equilibrium (`balance`). A separate piece without attachments is marked as
/// detached.
void set_going(Bodies& bodies, std::size_t body, std::size_t first, Motion motion, VecX balance);
/// Adds the body's new topology to the report.
TopologyChange& tell_of(const Bodies& bodies, std::size_t body, std::uint64_t content_hash,
                        TopologyCause cause, ParticipantId author, StepReport& report);

}  // namespace prosector
