#pragma once
// Restitution of rigid contacts in an island that was minimised.
//
// A minimised contact closes and stays closed, whatever its restitution. An overlap that was found late opens
// as fast as it is resolved. So after poses are integrated, contacts that pressed get the separation speed of
// Newton's law of impact (0 after an overlap). It is applied by sequential impulses, equal and opposite.
// Other pressing contacts are kept from closing.

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Returns the separation speed (m/s) after an impact of two rigid bodies: restitution × approach speed.
/// `approach`: relative normal velocity before the tick, m/s, negative when approaching. Returns 0 for
/// approach speeds of at most 0.2 m/s, so that resting bodies do not bounce under gravity.
double rebound_speed(double restitution, double approach);

/// Applies restitution to the rigid contacts that pressed in this tick of h s. Sets the rigid bodies' twists
/// to h times their velocities after the impacts, and adds the impulses to the contacts' forces. Returns
/// false, without changes, if no pressing contact has restitution or overlaps by more than 1 mm.
bool bounce(Island& island, double h);

}  // namespace prosector::coupled
