#pragma once
// Creates and updates the bodies of an organ's pieces after a change.

#include <memory>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Creates and updates the bodies of an organ's pieces after a cut, an undo or a rewind, and reports them.
/// Throws, and changes nothing, if that is impossible.
void remake(State& state, organs::Organ& organ, TopologyCause cause, ParticipantId author,
            StepReport& report);

/// Returns a new soft body for the given description and geometry, with the tissue properties (such as
/// material and attachments) of an existing body.
std::unique_ptr<soft::SoftBody> same_tissue(const Bodies& bodies, std::size_t body, SoftDesc desc,
                                            Anatomy anatomy);
/// Returns a new soft body for a piece of an organ, with the organ's material and a name derived from the
/// organ's. Writes the permanent numbers of the piece's nodes, vertices and triangles to `numbering`.
std::unique_ptr<soft::SoftBody> make_piece(const Bodies& bodies, const organs::Organ& organ, std::size_t body,
                                           Numbering& numbering);
/// Replaces the soft body at index `body` by `solver`, at rest. If there is no such body, appends it. `first`
/// is the index of the organ's original soft body. `surface` is built from the solver's anatomy.
void place_piece(State& state, std::size_t body, std::size_t first, std::unique_ptr<soft::SoftBody> solver,
                 Numbering numbering, contact::TissueSurface surface);

// ---- Also used by incremental updates after a cut (piece_follow.cpp)
/// Sets the motion of an organ's piece and its node positions at equilibrium (`balance`, 3n, m). A piece
/// without attachments, other than the organ's original body `first`, is marked as detached.
void set_going(Bodies& bodies, std::size_t body, std::size_t first, soft::Motion motion, VecX balance);
/// Appends the body's new topology to the report, with its content hash, cause and author. Returns the
/// appended entry.
TopologyChange& add_topology_change(const Bodies& bodies, std::size_t body, std::uint64_t content_hash,
                                    TopologyCause cause, ParticipantId author, StepReport& report);

}  // namespace prosector
