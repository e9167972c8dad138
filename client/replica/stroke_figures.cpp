#include "client/replica/stroke_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "client/replica/cut_rims.h"

namespace prosector {
namespace {

/// Returns only the rims of cuts: on a sheet, the borders that have an opposite side.
std::vector<CutRim> rims_of_cuts(const TriangleMesh& rest) {
  std::vector<CutRim> rims = cut_rims(rest);
  if (std::ranges::find(rest.inner, std::uint8_t{1}) != rest.inner.end()) return rims;
  std::vector<RestEdge> edges;
  for (const CutRim& rim : rims) edges.push_back({rest.positions[rim.a], rest.positions[rim.b]});
  const auto others = other_sides(edges);
  std::vector<CutRim> out;
  for (std::size_t k = 0; k < rims.size(); ++k)
    if (others[k]) out.push_back(rims[k]);
  return out;
}

double length_of(const std::vector<CutRim>& rims, const TriangleMesh& rest) {
  double sum = 0;
  for (const CutRim& rim : rims) sum += (rest.positions[rim.b] - rest.positions[rim.a]).norm();
  return sum;
}

/// Returns the maximum distance of the cut faces' vertices from slot `first` on to the rims, m.
double depth_of(const std::vector<CutRim>& rims, const TriangleMesh& rest, std::size_t first) {
  double deepest = 0;
  std::vector<std::uint8_t> seen(rest.positions.size(), 0);
  for (std::size_t t = 0; t < rest.inner.size(); ++t) {
    if (rest.inner[t] == 0) continue;
    for (const std::uint32_t v : rest.triangles[t]) {
      if (v < first || rims.empty() || std::exchange(seen[v], std::uint8_t{1}) != 0) continue;
      double nearest = std::numeric_limits<double>::infinity();
      for (const CutRim& rim : rims)
        nearest = std::min(nearest, (rest.positions[v] - rest.positions[rim.a]).squaredNorm());
      deepest = std::max(deepest, nearest);
    }
  }
  return std::sqrt(deepest);
}

long mm(double m) {
  return std::lround(1e3 * m);
}

}  // namespace

std::string depth_in_words(double depth, const Catalogue& words) {
  return words.tr("set to {} mm", mm(depth));
}

std::string in_words(const StrokeFigures& stroke, const Catalogue& words) {
  if (stroke.through) return words.tr("{} mm long, through the full thickness", mm(stroke.length));
  return mm(stroke.depth) > 0 ? words.tr("{} mm long, {} mm deep", mm(stroke.length), mm(stroke.depth))
                              : words.tr("{} mm long", mm(stroke.length));
}

void StrokeTracker::look(const Replica& replica, double now) {
  if (!replica.scene()) return;
  for (BodyId id = 0; id < replica.scene()->bodies.size(); ++id) {
    const TopologyRevision* newest = replica.bodies().topology(id);
    const auto known = bodies_.find(id);
    if (newest == nullptr || (known != bodies_.end() && known->second.revision == newest->revision)) continue;
    take(replica, id, *newest, now);
  }
  std::erase_if(strokes_, [&](const Stroke& stroke) {
    // The time restarts with another server.
    const bool over = now - stroke.last > stroke_seconds || now < stroke.last;
    if (over && stroke.figures.length > 0) ended_.push_back(stroke.figures);
    return over;
  });
  looked_ = true;
}

void StrokeTracker::take(const Replica& replica, BodyId id, const TopologyRevision& newest, double now) {
  const SoftReplica* soft = replica.bodies().soft(id);
  if (soft == nullptr) return;
  const bool is_new = !bodies_.contains(id);
  const bool is_piece = newest.piece_of >= 0 && bodies_.contains(static_cast<BodyId>(newest.piece_of));
  const BodyId organ =
      is_new ? (is_piece ? bodies_[static_cast<BodyId>(newest.piece_of)].organ : id) : bodies_[id].organ;
  const bool is_stroke =
      looked_ && newest.cause == TopologyCause::cut && (!is_new || is_piece) && newest.author != 0;
  Stroke* stroke = is_stroke ? &stroke_of(newest.author, organ) : nullptr;
  const std::vector<CutRim> rims = rims_of_cuts(soft->rest());
  Body& body = bodies_[id];
  if (stroke != nullptr && !is_new) stroke->vertices_before.try_emplace(id, body.vertices);
  body = {newest.revision, organ, length_of(rims, soft->rest()), soft->rest().positions.size()};
  if (stroke == nullptr) return;
  stroke->last = now;
  stroke->figures.through |= is_new;
  // A piece may arrive slightly after the body that it came off; until then its rims are missing.
  stroke->figures.length = std::max(stroke->figures.length, (rims_of(organ) - stroke->initial_rims) / 2);
  // A piece has the same cut faces as the body that it came off.
  if (!is_new)
    stroke->figures.depth =
        std::max(stroke->figures.depth, depth_of(rims, soft->rest(), stroke->vertices_before.at(id)));
}

StrokeTracker::Stroke& StrokeTracker::stroke_of(ParticipantId author, BodyId organ) {
  for (Stroke& stroke : strokes_)
    if (stroke.figures.author == author && stroke.figures.organ == organ) return stroke;
  Stroke& made = strokes_.emplace_back();
  made.figures.author = author;
  made.figures.organ = organ;
  made.initial_rims = rims_of(organ);
  return made;
}

double StrokeTracker::rims_of(BodyId organ) const {
  double sum = 0;
  for (const auto& [id, body] : bodies_)
    if (body.organ == organ) sum += body.rims;
  return sum;
}

const StrokeFigures* StrokeTracker::of(ParticipantId author) const {
  const Stroke* newest = nullptr;
  for (const Stroke& stroke : strokes_)
    if (stroke.figures.author == author && (newest == nullptr || stroke.last > newest->last))
      newest = &stroke;
  return newest != nullptr ? &newest->figures : nullptr;
}

std::vector<StrokeFigures> StrokeTracker::take_ended() {
  return std::exchange(ended_, {});
}

}  // namespace prosector
