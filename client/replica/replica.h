#pragma once
// A client's copy of the session state of one server. The network thread writes it and the view reads it:
// lock it.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "client/language/catalogue.h"
#include "client/replica/asset_store.h"
#include "client/replica/body_replicas.h"
#include "client/replica/session_time.h"
#include "client/replica/track.h"
#include "common/hand_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/part_messages.h"
#include "common/recording_messages.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"
#include "common/status_messages.h"
#include "idl/bus.h"
#include "idl/message.h"

namespace prosector {

class Replica {
 public:
  Replica() = default;
  /// Creates an empty replica that already has another replica's assets (meshes and maps). They are
  /// identified by their content hash, so they are valid for any server. Body names are shown in `language`,
  /// a tag such as "de", if the scene has such names.
  explicit Replica(AssetStore assets, std::string language = "")
      : assets_(std::move(assets)), language_(std::move(language)) {}

  /// Updates the replica by a received message. Inconsistent messages, such as a body that isn't in the scene
  /// or an asset that is no mesh, are counted and ignored.
  void apply(const Received& received);

  /// Returns whether the session can be displayed: the scene, all its meshes, the topology log and a first
  /// state of every soft body have arrived. It stays true after cuts, because new topology is not shown until
  /// its data has arrived.
  bool complete() const { return complete_; }
  /// Returns a text for the user, in the language of `words`, on the data that must still arrive before the
  /// session can be displayed: "waiting for 3 of 12 meshes …". Returns an empty string if nothing is missing.
  std::string missing(const Catalogue& words = {}) const;
  /// Returns the received fraction of the data that is needed to display the session, 0 … 1.
  double progress() const;

  const std::optional<SessionInfo>& session() const { return session_; }
  const std::optional<SceneInfo>& scene() const { return scene_; }
  const std::map<ParticipantId, RosterEntry>& roster() const { return roster_; }
  const std::optional<ServerStatus>& status() const { return status_; }
  /// Returns the newest contact sample of a participant's hand: its strongest contact, or the one that it is
  /// about to make first. Returns null if there is none, or none within the last 0.25 s.
  const ContactSample* contact(ParticipantId participant, std::size_t hand) const;
  /// Returns the newest status that the server sent for a soft body; null before the first, and for rigid
  /// bodies.
  const BodyStatus* body_status(BodyId body) const;
  BodyReplicas& bodies() { return bodies_; }
  const BodyReplicas& bodies() const { return bodies_; }
  /// Returns the state of an anatomical part, such as its visibility; null while nobody has changed it.
  const PartState* part(BodyId body) const;
  /// Returns the open panels, each with the controls of one anatomical part, by the participant that opened
  /// the panel.
  const std::map<ParticipantId, Panel>& panels() const { return panels_; }
  /// Returns the brightness of the room's lights, 0 (off) … 1 (full). Lights that bodies carry are not
  /// included.
  double room_lights() const { return room_lights_; }
  /// Returns the description of the recording that the server replays; nullopt if the session is live.
  const std::optional<Recording>& recording() const { return recording_; }
  bool server_gone() const { return server_gone_; }
  const AssetStore& assets() const { return assets_; }
  std::uint64_t refused() const;

  // ---- State at the playhead
  SessionTime& time() { return time_; }
  const SessionTime& time() const { return time_; }
  Pose rigid_pose(BodyId body, double tick) const;
  std::optional<UserState> user(ParticipantId participant, double tick) const;

 private:
  AssetStore assets_;
  std::string language_;
  std::optional<SessionInfo> session_;
  std::optional<SceneInfo> scene_;
  SessionTime time_;
  std::map<ParticipantId, RosterEntry> roster_;
  std::map<ParticipantId, Track<UserState>> users_;
  std::map<std::pair<ParticipantId, std::uint8_t>, ContactSample> contacts_;
  BodyReplicas bodies_;
  std::optional<ServerStatus> status_;
  std::optional<Recording> recording_;
  std::map<BodyId, BodyStatus> body_status_;
  std::map<BodyId, PartState> parts_;
  std::map<ParticipantId, Panel> panels_;
  double room_lights_ = 1;
  bool complete_ = false, lacks_bodies_ = true, server_gone_ = false;
  std::uint64_t refused_ = 0;

  void apply(const Message& message, std::int64_t arrival_ns);
  void forget(const Message& message);
  void build_bodies(std::int64_t now_ns);
};

}  // namespace prosector
