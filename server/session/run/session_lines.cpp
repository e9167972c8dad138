#include "server/session/run/session_lines.h"

#include <fmt/format.h>

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
      return fmt::format("{} is disconnected (left or connection lost)", e.name);
    case SessionEvent::Kind::hand_timeout:
      return fmt::format("{}: {} no longer tracked, released", e.name, e.detail);
    case SessionEvent::Kind::hand_stalled:
      return fmt::format("{}: {} released, its client sent nothing for too long", e.name, e.detail);
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

}  // namespace prosector
