#pragma once
// Parser of the client's terminal commands: roles, parts, time, views.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/replica/shown_time.h"
#include "common/commands.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"

namespace prosector {

/// Returns the help for all terminal commands, regardless of the user's role.
std::string console_help();

/// Request to save a screenshot.
struct TakePicture {
  std::filesystem::path file;
};

/// New camera pose for offscreen images: from `eye` towards `target` (m, world frame).
struct LookFrom {
  Vec3 eye, target;
};
/// Request to restore the scene's own camera pose.
struct RestoreView {};

/// Request to list the cuts.
struct ListCuts {};

/// Request to name the part under the pointer.
struct DescribePointed {};

/// Result of a line: a command to the server, a request to the client, or an error message.
using ConsoleLine =
    std::variant<CommandBody, TakePicture, LookFrom, RestoreView, ListCuts, DescribePointed, std::string>;

/// Parses a line. Names are those of the roster and the scene and may contain spaces. `middle` returns the
/// centre of a body in the room, m. `watched` is the displayed time of a recording; nullopt: the session is
/// live.
ConsoleLine parse_console_line(const std::string& line, const SceneInfo& scene,
                               const std::map<ParticipantId, RosterEntry>& roster,
                               const std::function<Vec3(BodyId)>& middle,
                               const std::optional<ShownTime>& watched = std::nullopt);

/// Standard input. take() returns the lines typed since the last call without blocking. Closes silently at
/// end of file.
class Console {
 public:
  Console();
  std::vector<std::string> take();

 private:
  bool open_;
  std::string rest_;
};

}  // namespace prosector
