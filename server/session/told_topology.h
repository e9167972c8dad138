#pragma once
// The topology of a recorded session as clients are told. The recording goes back and forth; what clients
// follow only grows. So a body that has become another, forwards or backwards, gets a revision of its own. A
// piece that is not there yet is told to be nothing.

#include <map>
#include <span>
#include <vector>

#include "server/session/recording_index.h"
#include "server/session/simulated_shapes.h"

namespace prosector {

class ToldTopology {
 public:
  /// Takes the content that was announced, which is of the simulation as it is now. All outlive this.
  ToldTopology(const SceneContent& content, const Simulation& simulation, const RecordingIndex& index);

  /// Follows a tick that was run; `people`: who was there. Appends what has to be said, in order.
  void follow(std::span<const TopologyChange> changes, SimTime time, const Roster& people,
              std::vector<Outgoing>& out);
  /// Follows to another time of the recording.
  void jump(SimTime time, const Roster& people, std::vector<Outgoing>& out);

  TopologyLog& log() { return log_; }
  const TopologyLog& log() const { return log_; }

 private:
  struct Told {
    std::uint32_t revision = 0;  // the recording's
    std::uint64_t content_hash = 0;
    bool operator==(const Told&) const = default;
  };
  const Simulation& simulation_;
  const RecordingIndex& index_;
  TopologyLog log_;
  std::map<BodyId, Told> told_;  // of soft bodies that clients know; a piece that is not there: Told{}

  Told now(BodyId body) const;
  TopologyChange beginning_of(BodyId piece) const;
};

}  // namespace prosector
