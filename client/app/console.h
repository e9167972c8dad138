#pragma once
// What a person types into the client's terminal: who gets which role, what happens to parts.

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "common/messages.h"

namespace prosector {

inline constexpr const char* console_help =
    "give NAME host|dissector|observer    (the host only)\n"
    "detach PART    attach PART    reset BODY\n"
    "inspect PART [SCALE]    end PART    (shows it SCALE times as large, out of touch)";

/// A line as a command to the server, or, in words, why it is none. Names are those of the roster and the
/// scene; they may hold spaces. `middle`: of a body, in the room, m.
std::variant<Command, std::string> parse_console_line(const std::string& line, const SceneInfo& scene,
                                                      const std::map<ParticipantId, RosterEntry>& roster,
                                                      const std::function<Vec3(BodyId)>& middle);

/// Lines that were typed since the last call; waits for none. Ends quietly with standard input.
class Console {
 public:
  Console();
  std::vector<std::string> take();

 private:
  bool open_;
  std::string rest_;
};

}  // namespace prosector
