#include "client/setup/procedures.h"

#include "client/language/catalogue.h"

namespace prosector {

std::span<const ProcedureRow> tracker_procedures() {
  static const std::vector<ProcedureRow> rows = {
      {msg("Position in the room"),
       msg("Touch points with known positions in the room. This determines the position of the tracker."),
       begin_room,
       {CalibrationSetting::role, CalibrationSetting::points}},
      {msg("Instrument's tip"),
       msg("Rest the tip in a dent and swing the instrument about it. This determines the position of the "
           "tip."),
       begin_tip,
       {CalibrationSetting::role}},
      {msg("Field distortion"),
       msg("Hold the receiver at the points of a grid. This maps the distortion caused by metal and corrects "
           "it."),
       begin_field,
       {CalibrationSetting::role, CalibrationSetting::grid}},
      {msg("Noise"),
       msg("Keep a receiver at rest. Reports its noise and drift."),
       begin_noise,
       {CalibrationSetting::role, CalibrationSetting::seconds}},
      {msg("Latency"),
       msg("Move a receiver together with a second device. This determines how much later the receiver "
           "reports."),
       begin_latency,
       {CalibrationSetting::role, CalibrationSetting::seconds, CalibrationSetting::against}},
      {msg("Phantom"),
       msg("Touch points of a real body with an instrument's tip. This determines the pose of its shape, on "
           "its board or in the room."),
       begin_phantom,
       {CalibrationSetting::role, CalibrationSetting::shape, CalibrationSetting::landmarks}}};
  return rows;
}

std::span<const ProcedureRow> glove_procedures() {
  static const std::vector<ProcedureRow> rows = {
      {msg("Sensor range"),
       msg("Hold the hand flat, as a fist, and with each finger bent. This determines the finger angle for "
           "each sensor count."),
       begin_glove,
       {CalibrationSetting::hand}}};
  return rows;
}

}  // namespace prosector
