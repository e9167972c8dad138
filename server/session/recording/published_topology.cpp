#include "server/session/recording/published_topology.h"

namespace prosector {
namespace {

/// Soft bodies of the simulation; those that it does not have are empty.
class ShapesAtThatTime final : public SoftShapes {
 public:
  explicit ShapesAtThatTime(const Simulation& simulation) : simulation_(simulation), shapes_(simulation) {}
  Shape shape(BodyId body) const override {
    return body < simulation_.body_count() ? shapes_.shape(body) : Shape{nothing_, no_numbers_, nowhere_};
  }
  SceneBody describe(BodyId body, const SurfaceLog& surface) const override {
    return shapes_.describe(body, surface);
  }

 private:
  const Simulation& simulation_;
  SimulatedShapes shapes_;
  Anatomy nothing_;
  Numbering no_numbers_;
  VecX nowhere_;
};

}  // namespace

PublishedTopology::PublishedTopology(const SceneContent& content, const Simulation& simulation,
                                     const RecordingIndex& index)
    : simulation_(simulation), index_(index), log_(content, simulation.scene().tick_rate) {
  for (BodyId body = 0; body < simulation.body_count(); ++body)
    if (simulation.kind(body) == BodyKind::soft) published_[body] = now(body);
}

void PublishedTopology::follow(std::span<const TopologyChange> changes, SimTime time, const Roster& people,
                               std::vector<Outgoing>& out) {
  const ShapesAtThatTime shapes(simulation_);
  for (TopologyChange change : changes) {
    published_[change.body] = {change.revision, change.content_hash};
    if (log_.knows(change.body)) change.revision = log_.revision(change.body) + 1;
    log_.follow(shapes, {&change, 1}, time, people, out);
  }
  log_.take_records();
}

void PublishedTopology::jump(SimTime time, const Roster& people, std::vector<Outgoing>& out) {
  const ShapesAtThatTime shapes(simulation_);
  for (BodyId body = 0; body < simulation_.body_count(); ++body)
    if (simulation_.kind(body) == BodyKind::soft && !log_.knows(body)) {
      const TopologyChange piece = beginning_of(body);
      log_.follow(shapes, {&piece, 1}, time, people, out);
      published_[body] = now(body);
    }
  for (auto& [body, published] : published_) {
    const Published at_that_time = now(body);
    if (published == at_that_time) continue;
    published = at_that_time;
    TopologyChange change;
    change.body = body;
    change.revision = log_.revision(body) + 1;
    change.content_hash = published.content_hash;
    change.cause = TopologyCause::rewind;
    log_.follow(shapes, {&change, 1}, time, people, out);
  }
  log_.take_records();
}

PublishedTopology::Published PublishedTopology::now(BodyId body) const {
  if (body >= simulation_.body_count()) return {};
  return {simulation_.revision(body), simulation_.topology_hash(body)};
}

/// Returns the change that introduces a piece to clients, in its present state.
TopologyChange PublishedTopology::beginning_of(BodyId piece) const {
  TopologyChange out;
  out.body = piece;
  out.content_hash = simulation_.topology_hash(piece);
  if (const TopologyRevision* first = index_.beginning_of(piece)) {
    out.author = first->author;
    out.piece_of = static_cast<BodyId>(first->piece_of);
  }
  return out;
}

}  // namespace prosector
