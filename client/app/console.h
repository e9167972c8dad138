#pragma once
// What a person types into the client's terminal: who gets which role, what happens to parts.

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/replica/shown_time.h"
#include "common/messages.h"

namespace prosector {

/// Returns what can be typed, for people: all that there is, whoever asks.
std::string console_help();

/// A picture to take now.
struct TakePicture {
  std::filesystem::path file;
};

/// A new view of pictures that no desk turns: from `eye`, towards `target` (m, world frame).
struct LookFrom {
  Vec3 eye, target;
};
/// The scene's own view again.
struct LookAsBefore {};

/// A request for what was cut.
struct ListCuts {};

/// A request for what the pointer is at.
struct TellPointed {};

/// A command to the server, something that the client does itself, or, in words, why it is neither.
using ConsoleLine =
    std::variant<Command, TakePicture, LookFrom, LookAsBefore, ListCuts, TellPointed, std::string>;

/// Reads a line. Names are those of the roster and the scene; they may hold spaces. `middle` returns that of
/// a body in the room, m; `watched` is of the recording that is watched.
ConsoleLine parse_console_line(const std::string& line, const SceneInfo& scene,
                               const std::map<ParticipantId, RosterEntry>& roster,
                               const std::function<Vec3(BodyId)>& middle,
                               const std::optional<ShownTime>& watched = std::nullopt);

/// Standard input: take() returns the lines that were typed since the last call and waits for none. Ends
/// quietly with standard input.
class Console {
 public:
  Console();
  std::vector<std::string> take();

 private:
  bool open_;
  std::string rest_;
};

}  // namespace prosector
