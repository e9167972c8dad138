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

/// Returns the help text on all commands that can be typed in the client's terminal, regardless of the user's
/// role.
std::string console_help();

/// Request of a terminal command to save a screenshot in a file.
struct TakePicture {
  std::filesystem::path file;
};

/// Request of a terminal command to set the camera of offscreen frames: from `eye` towards `target` (m, world
/// frame).
struct LookFrom {
  Vec3 eye, target;
};
/// Request of a terminal command to use the scene's own camera for offscreen frames again.
struct RestoreView {};

/// Request of a terminal command to list the cuts of the session.
struct ListCuts {};

/// Request of a terminal command to name the body under the mouse pointer.
struct DescribePointed {};

/// Result of a line typed in the terminal: a command to the server, a request to this client, or an error
/// message.
using ConsoleLine =
    std::variant<CommandBody, TakePicture, LookFrom, RestoreView, ListCuts, DescribePointed, std::string>;

/// Parses a line typed in the terminal. Names are those of the roster and the scene and may contain spaces.
/// `middle` returns the centre of a body in the room, m. `watched`: displayed time of a recording; nullopt if
/// the session is live.
ConsoleLine parse_console_line(const std::string& line, const SceneInfo& scene,
                               const std::map<ParticipantId, RosterEntry>& roster,
                               const std::function<Vec3(BodyId)>& middle,
                               const std::optional<ShownTime>& watched = std::nullopt);

/// Reader of the lines that the user types on standard input. take() returns those since the last call
/// without blocking. At the end of file it stops reading, without an error.
class Console {
 public:
  Console();
  std::vector<std::string> take();

 private:
  bool open_;
  std::string rest_;
};

}  // namespace prosector
