#pragma once
// What people make of the parts: who is in its place, who can be touched, how stiff tissue is.

#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Obeys the event, or returns why not.
Refusal obey(State& state, const PartEvent& event, StepReport& report);
/// Puts the body where the scene has it, at rest and untouched by what people made of it. A bone that broke
/// is put back whole.
void reset_body(State& state, BodyId body, StepReport& report);
/// Puts the body where the scene has it, at rest; tissue in its equilibrium.
void put_at_start(Bodies& bodies, BodyId body);

}  // namespace prosector
