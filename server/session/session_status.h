#pragma once
// What every server tells of itself, live or with a recording.

#include "idl/bus.h"
#include "server/session/session.h"
#include "server/session/step_meter.h"

namespace prosector {

/// Returns the status but for the time, the state's hash and what is degraded.
ServerStatus status_of(const StepMeter& meter, const Session& session, const Bus& bus);

}  // namespace prosector
