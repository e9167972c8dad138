#pragma once
// Small scenes in code, and a block of tetrahedra to fill them.

#include <functional>

#include "server/physics/simulation.h"

namespace prosector::test {

/// A box around the origin in cells of six tetrahedra; its surface is its boundary.
/// Without the cells that are `hollow`.
Anatomy make_block(const Vec3& size, const std::array<int, 3>& cells,
                   const std::function<bool(int, int, int)>& hollow = {});

/// These tetrahedra, with their own boundary as the surface.
Anatomy with_boundary(TetMesh mesh);

/// The table: its top at y = 0.
RigidDesc table();
RigidDesc part_body(const std::string& name, const std::string& shape, const Vec3& size, const Vec3& at,
                    double density = 1000);
/// A block on the table, E = 5.4 kPa; 0.1 × 0.06 × 0.1 m, standing on y = 0.
SoftDesc block(const std::string& name = "block");

/// Fills every soft body but sheets and ropes, whatever its shape, with a box of cells of about `desc.cell`.
CompileOptions options(int threads = 1);

/// Steps `ticks` times with the same input after the events of the first.
void run(Simulation& simulation, int ticks, const TickInput& input = {});

/// J: kinetic, elastic and potential.
double energy(const StepReport& report);

inline constexpr ParticipantId somebody = 7;
TickInput appear(const Vec3& at, const Quat& q = Quat::Identity());
TickInput target(const Vec3& at, const Quat& q = Quat::Identity(), double flexion = 0);
TickInput event(HandEvent::Kind kind, const Vec3& at);

}  // namespace prosector::test
