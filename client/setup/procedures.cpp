#include "client/setup/procedures.h"

#include "client/language/catalogue.h"

namespace prosector {

std::span<const ProcedureRow> tracker_procedures() {
  static const std::vector<ProcedureRow> rows = {
      {msg("Place in the room"),
       msg("Touch points whose place in the room is known: the tracker's own place follows."),
       begin_room,
       {Asked::role, Asked::points}},
      {msg("Instrument's tip"),
       msg("Rest the tip in a dent and swing the instrument about it: where the tip is follows."),
       begin_tip,
       {Asked::role}},
      {msg("Bent field"),
       msg("Hold the receiver at the points of a grid: what metal bends is mapped and taken out."),
       begin_field,
       {Asked::role, Asked::grid}},
      {msg("Noise"),
       msg("Let a receiver rest: how much it trembles and drifts is told."),
       begin_noise,
       {Asked::role, Asked::seconds}},
      {msg("Latency"),
       msg("Move a receiver together with a second device: how much later this one tells it follows."),
       begin_latency,
       {Asked::role, Asked::seconds, Asked::against}},
      {msg("Phantom"),
       msg("Touch points of a real body with an instrument's tip: where its shape is follows, on its board "
           "or in "
           "the room."),
       begin_phantom,
       {Asked::role, Asked::shape, Asked::landmarks}}};
  return rows;
}

std::span<const ProcedureRow> glove_procedures() {
  static const std::vector<ProcedureRow> rows = {
      {msg("What counts mean"),
       msg("Hold the hand flat, as a fist, and with each finger bent: what counts mean follows."),
       begin_glove,
       {Asked::hand}}};
  return rows;
}

}  // namespace prosector
