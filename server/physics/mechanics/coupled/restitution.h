#pragma once
// Restitution of rigid contacts in an island that was minimised.
//
// A minimised contact closes and stays closed, whatever its restitution. An overlap that was found late opens
// as fast as it is resolved. So after poses are integrated, contacts that pressed get the separation speed of
// Newton's law of impact (0 after an overlap). It is applied by sequential impulses, equal and opposite.
// Other pressing contacts are kept from closing.

#include "server/physics/mechanics/coupled/island.h"

namespace prosector {

/// Returns the separation speed of bodies with relative normal velocity `approach` (m/s, < 0: approaching)
/// before the tick. It is 0 below the approach speed that gravity alone gives a resting body.
double rebound_speed(double restitution, double approach);

/// Sets the rigid twists to h times the velocities after the impacts, and adds the impulses to the contacts'
/// forces. Returns false if there was no impact.
bool bounce(Island& island, double h);

}  // namespace prosector
