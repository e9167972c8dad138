#include "server/session/run/session_lines.h"

#include <fmt/format.h>

#include "common/count_text.h"
#include "common/percent_text.h"

namespace prosector {

std::string line_of(const SessionEvent& e) {
  switch (e.kind) {
    case SessionEvent::Kind::joined:
      return fmt::format("{} joins as {}", e.name, e.detail);
    case SessionEvent::Kind::refused:
      return fmt::format("\"{}\" was refused: {}", e.name, e.detail);
    case SessionEvent::Kind::left:
      return fmt::format("{} leaves", e.name);
    case SessionEvent::Kind::lost:
      return fmt::format("{} is disconnected (the client ended or the connection was lost)", e.name);
    case SessionEvent::Kind::hand_timeout:
      return fmt::format("{}: {} no longer tracked, released", e.name, e.detail);
    case SessionEvent::Kind::hand_stalled:
      return fmt::format("{}: {} released, because the participant's client sent nothing for too long",
                         e.name, e.detail);
    case SessionEvent::Kind::role:
      return fmt::format("{} is now {}", e.name, e.detail);
    case SessionEvent::Kind::let_go:
      return fmt::format("{} released: {}", e.name, e.detail);
    case SessionEvent::Kind::broke:
      return fmt::format("{} broke {}", e.name, e.detail);
    case SessionEvent::Kind::rewound:
      return fmt::format("{} rewound everything to {}", e.name, e.detail);
    case SessionEvent::Kind::pace:
    case SessionEvent::Kind::effort:
    case SessionEvent::Kind::accuracy:
      return fmt::format("{} {}", e.name, e.detail);
  }
  return {};
}

std::string line_of(const ServerStatus& s, const Simulation& simulation, const BodyMeter& bodies) {
  std::string line = fmt::format(
      "{:7.1f} s  x{:.2f} real time | step {:.1f} ms p50, {:.1f} p99 | {}, {} | {} messages dropped | {} "
      "bodies awake, {} asleep",
      static_cast<double>(s.time.tick) / simulation.scene().tick_rate, s.real_time_factor, s.step_ms_p50,
      s.step_ms_p99, counted(s.participants, "participant"), counted(s.observers, "observer"),
      s.invalid_dropped, s.awake_bodies, s.asleep_bodies);
  for (const auto& [body, status] : bodies.newest())
    if (status.error >= 0 && !status.asleep) {
      line +=
          fmt::format(" | {}: {}, residual {:.0e}", simulation.name(body),
                      is_known_error(status.error) ? fmt::format("about {} off", percent_text(status.error))
                                                   : "error not known",
                      status.residual);
      if (status.press_error >= 0)
        line += is_known_error(status.press_error)
                    ? fmt::format(", pressed: force within {}", percent_text(status.press_error))
                    : ", pressed: error not known";
    }
  if (!s.degraded.empty()) line += " | degraded: " + s.degraded;
  return line;
}

}  // namespace prosector
