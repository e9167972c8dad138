#pragma once
// What an organ's change left or made of its pieces becomes bodies.

#include <memory>

#include "server/physics/organs/organ.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Makes bodies of the pieces that an organ's change left or made. Throws, and changes nothing, where that
/// can't be.
void remake(State& state, Organ& organ, TopologyCause cause, ParticipantId author, StepReport& report);

/// Returns a solver of the same tissue as a body's, of other geometry.
std::unique_ptr<SoftBody> same_tissue(const Bodies& bodies, std::size_t body, SoftDesc desc, Anatomy anatomy);
/// Returns the solver of a piece: named after the organ, and of its material. Fills `numbering`.
std::unique_ptr<SoftBody> make_piece(const Bodies& bodies, const Organ& organ, std::size_t body,
                                     Numbering& numbering);
/// Puts a solver in the place of the body's, at rest; or at the end, where the body is new. `first`: the soft
/// body that the organ was. `surface`: of the solver's anatomy.
void place_piece(State& state, std::size_t body, std::size_t first, std::unique_ptr<SoftBody> solver,
                 Numbering numbering, TissueSurface surface);

// ---- What following a cut uses, too (piece_follow.cpp)
/// Lets a piece move as what was there did. One that nothing ties to its place any more is out of it.
void set_going(Bodies& bodies, std::size_t body, std::size_t first, Motion motion, VecX balance);
/// Tells of the body's new topology.
TopologyChange& tell_of(const Bodies& bodies, std::size_t body, std::uint64_t content_hash,
                        TopologyCause cause, ParticipantId author, StepReport& report);

}  // namespace prosector
