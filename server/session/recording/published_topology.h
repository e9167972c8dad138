#pragma once
// The topology of a recorded session as sent to clients. The recording may jump back and forth, but revisions
// that clients follow only rise. So a body that changed, forwards or backwards, gets a new revision. A piece
// that does not exist at the present time is sent as empty.

#include <map>
#include <span>
#include <vector>

#include "server/session/recording/recording_index.h"
#include "server/session/sending/simulated_shapes.h"

namespace prosector {

class PublishedTopology {
 public:
  /// Starts with the scene content that was announced to clients, which must describe the simulation's
  /// current state. All arguments must outlive the object.
  PublishedTopology(const SceneContent& content, const Simulation& simulation, const RecordingIndex& index);

  /// Processes the topology changes of a recorded tick that was run. Appends the messages for clients to
  /// `out`, in order. `people` are the recorded participants.
  void follow(std::span<const TopologyChange> changes, SimTime time, const Roster& people,
              std::vector<Outgoing>& out);
  /// Processes a jump to another time of the recording: bodies whose topology differs there get a new
  /// revision. Appends the messages for clients to `out`, in order. `people` are the recorded participants.
  void jump(SimTime time, const Roster& people, std::vector<Outgoing>& out);

  TopologyLog& log() { return log_; }
  const TopologyLog& log() const { return log_; }

 private:
  struct Published {
    std::uint32_t revision = 0;  // revision in the recording
    std::uint64_t content_hash = 0;
    bool operator==(const Published&) const = default;
  };
  const Simulation& simulation_;
  const RecordingIndex& index_;
  TopologyLog log_;
  std::map<BodyId, Published>
      published_;  // of soft bodies that clients know; a piece that does not exist: `Published{}`

  Published now(BodyId body) const;
  TopologyChange beginning_of(BodyId piece) const;
};

}  // namespace prosector
