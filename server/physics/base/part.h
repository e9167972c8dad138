#pragma once
// State of anatomical parts that users change: detached and attached, hidden, inspected.

#include "common/ids.h"
#include "common/math.h"

namespace prosector {

/// User action on a part. Journalled with the tick that consumes it; applied after the hands' events.
struct PartEvent {
  enum class Kind : std::uint8_t {
    detach,         // lets it go from its place
    attach,         // back into its place, from no farther than its `snap`
    inspect,        // shown as `shape` has it, and out of touch, until …
    end_inspect,    // … it is where it was
    hide,           // neither seen nor touched; it stays where it is
    show,           // ends that
    set_opacity,    // to `value`, 0 … 1
    set_stiffness,  // soft: to `value` times the scene's, min_stiffness … max_stiffness
    light,          // the light shaft on it: `value` 0 off, 1 on
  } kind = Kind::detach;
  ParticipantId participant = 0;
  BodyId body = 0;
  Affine shape;
  double value = 0;
};
inline constexpr PartEvent::Kind last_part_event = PartEvent::Kind::light;

/// Current user-made changes of a body; included in the simulation's state.
struct Part {
  bool attached = true;  // in its place
  bool hidden = false;
  bool lit = false;
  bool inspected = false;
  double opacity = 1;
  double stiffness = 1;  // times what the scene says
  Affine shape;          // while inspected

  bool out_of_touch() const { return hidden || inspected; }
  bool operator==(const Part& o) const {
    return attached == o.attached && hidden == o.hidden && lit == o.lit && inspected == o.inspected &&
           opacity == o.opacity && stiffness == o.stiffness && shape.A == o.shape.A && shape.p == o.shape.p;
  }
};

}  // namespace prosector
