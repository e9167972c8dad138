#include "server/session/run/summary.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace prosector {

bool write_summary(const std::filesystem::path& file, const ServerLoop& loop, const Simulation& simulation,
                   const std::filesystem::path& journal) {
  const RunFigures f = loop.figures();
  const StepMeter& meter = loop.meter();
  nlohmann::ordered_json out;
  out["scene"] = simulation.scene().name;
  out["tets"] = tet_count(simulation);
  out["participants"] = f.participants;
  out["observers"] = f.observers;
  out["real_time_factor"] = f.real_time_factor;
  out["real_time_factor_with_participants"] = f.real_time_factor_with_participants;
  // The main figure is the cost of ticks with tissue in motion; if there are none, that of all ticks.
  const DurationHistogram& awake = meter.awake().count() > 0 ? meter.awake() : meter.all();
  out["step_ms_p50"] = awake.quantile(0.5);
  out["step_ms_p99"] = awake.quantile(0.99);
  out["step_ms_p50_overall"] = meter.all().quantile(0.5);
  out["step_ms_p99_overall"] = meter.all().quantile(0.99);
  out["ticks"] = f.ticks;
  out["late_steps"] = f.late_ticks;
  out["schedule_slips"] = f.slips;
  out["invalid_dropped"] = f.invalid_dropped;
  out["hand_timeouts"] = f.hand_timeouts;
  out["refused_checkpoints"] = f.refused_checkpoints;
  out["commands"] = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < command_names.size(); ++k)
    if (const CommandCount& c = f.commands[k]; c.granted + c.refused > 0)
      out["commands"][command_names[k]] = {{"granted", c.granted}, {"refused", c.refused}};
  out["degraded_ticks"] = meter.troubles();
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (simulation.kind(b) != BodyKind::soft) continue;
    const std::string& name = simulation.name(b);
    const auto most = f.max_displacement_mm.find(name);
    out["max_displacement_mm"][name] = most == f.max_displacement_mm.end() ? 0.0 : most->second;
    out["residual_displacement_mm"][name] = 1e3 * simulation.max_displacement(b);
    const BodyStatus& status = loop.body_meter().newest().at(b);
    if (status.error >= 0)
      out["error"][name] = {{"all", status.error},
                            {"discretisation", status.parts.discretisation},
                            {"model", status.parts.model},
                            {"solver", status.parts.solver},
                            {"time", status.parts.time}};
    if (const auto press = loop.body_meter().presses().find(b); press != loop.body_meter().presses().end())
      out["pressed"][name] = {{"force_n", press->second.force}, {"error", press->second.error}};
    if (name == "liver") out["max_liver_displacement_mm"] = out["max_displacement_mm"][name];
  }
  out["state_hash"] = to_hex(f.state_hash);
  out["journal"] = journal.string();
  std::ofstream stream(file);
  stream << out.dump(2) << "\n";
  stream.flush();
  return stream.good();
}

}  // namespace prosector
