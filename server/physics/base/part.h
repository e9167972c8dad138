#pragma once
// State of anatomical parts that users change: detached and attached, hidden, inspected.

#include "common/ids.h"
#include "common/math.h"

namespace prosector {

/// A participant's action on an anatomical part, such as detaching or hiding it. It is recorded in the
/// journal with the tick that consumes it, and applied after the hands' events of that tick.
struct PartEvent {
  enum class Kind : std::uint8_t {
    detach,         // detaches it from its place
    attach,         // attaches it at its place again, if it is no farther away than its `snap`
    inspect,        // displays it as transformed by `shape`, and makes it untouchable
    end_inspect,    // ends `inspect`
    hide,           // makes it invisible and untouchable at its position
    show,           // ends `hide`
    set_opacity,    // to `value`, 0 … 1
    set_stiffness,  // soft body: factor `value` on the scene's stiffness, min_stiffness … max_stiffness
    light,          // switches the light shaft on the part: `value` 0 off, 1 on
  } kind = Kind::detach;
  ParticipantId participant = 0;
  BodyId body = 0;
  Affine shape;
  double value = 0;
};
inline constexpr PartEvent::Kind last_part_event = PartEvent::Kind::light;

/// Changes that participants have made to a body: attachment, visibility, inspection, opacity and stiffness.
/// They are included in the simulation's state.
struct Part {
  bool attached = true;  // in its place
  bool hidden = false;
  bool lit = false;
  bool inspected = false;
  double opacity = 1;
  double stiffness = 1;  // factor on the scene's stiffness
  Affine shape;          // while inspected

  bool out_of_touch() const { return hidden || inspected; }
  bool operator==(const Part& o) const {
    return attached == o.attached && hidden == o.hidden && lit == o.lit && inspected == o.inspected &&
           opacity == o.opacity && stiffness == o.stiffness && shape.A == o.shape.A && shape.p == o.shape.p;
  }
};

}  // namespace prosector
