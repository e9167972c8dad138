#pragma once
// Impacts among the rigid bodies of an island that was minimised.
//
// A minimised contact closes and stays closed, whatever the restitution. One that was found late, as an
// overlap, opens as fast as the overlap is undone. So after poses are integrated, contacts that pressed get
// the speed at which their sides part (Newton's law of impact; none, where it was an overlap). They get it by
// sequential impulses, equal and opposite. Contacts that press beside them are kept from closing.

#include "server/physics/island.h"

namespace prosector {

/// Returns the speed at which bodies part that approached at `approach` (m/s, < 0: nearer) before the tick.
/// There is no bounce below the speed that weight alone gives a body at rest.
double rebound_speed(double restitution, double approach);

/// Changes the rigid twists to h times the velocities after the impacts, and adds their impulses to the
/// contacts' forces. False: there was none.
bool bounce(Island& island, double h);

}  // namespace prosector
