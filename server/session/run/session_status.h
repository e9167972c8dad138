#pragma once
// The status that every server reports, of a live session or a recording.

#include "idl/bus.h"
#include "server/session/people/session.h"
#include "server/session/run/step_meter.h"

namespace prosector {

/// Returns a server's status, except for the time, the state's hash, the error and the degraded bodies, which
/// the caller sets.
ServerStatus status_of(const StepMeter& meter, const Session& session, const Bus& bus);

}  // namespace prosector
