#include "client/replica/soft_replica.h"

#include <algorithm>

namespace prosector {

SoftReplica::SoftReplica(const SceneBody& body, TriangleMesh rest, StreamedSurface streamed)
    : points_(body.points),
      chunk_points_(body.chunk_points),
      rest_(std::move(rest)),
      streamed_(std::move(streamed)) {
  chunks_.resize((points_ + chunk_points_ - 1) / chunk_points_);
  current_.assign(points_, Vec3::Zero());
  surface_.reserve(rest_.positions.size());
  for (const Vec3& x : rest_.positions) surface_.push_back(x.cast<float>());
}

std::uint32_t SoftReplica::size_of(std::uint32_t chunk) const {
  return std::min(chunk_points_, points_ - chunk * chunk_points_);
}

void SoftReplica::add(std::uint32_t chunk, Chunk sample) {
  if (chunks_[chunk].empty()) known_points_ += size_of(chunk);
  chunks_[chunk].add(std::move(sample));
}

void SoftReplica::add(const SoftState& s) {
  if (s.chunk >= chunks_.size() || s.first_point != s.chunk * chunk_points_ ||
      s.positions.size() != size_of(s.chunk) || s.velocities.size() != s.positions.size()) {
    ++dropped_;
    return;
  }
  Chunk chunk{s.time, s.positions, s.velocities};
  for (std::uint32_t i = 0; i < chunk.positions.size(); ++i)
    chunk.positions[i] += streamed_.rest[s.first_point + i];
  add(s.chunk, std::move(chunk));
}

void SoftReplica::add(const Settled& settled) {
  if (settled.positions.size() != points_) {
    ++dropped_;
    return;
  }
  for (std::uint32_t c = 0; c < chunks_.size(); ++c) {
    Chunk chunk{settled.time, std::vector<Vec3>(size_of(c)), std::vector<Vec3>(size_of(c), Vec3::Zero())};
    for (std::uint32_t i = 0; i < size_of(c); ++i)
      chunk.positions[i] = settled.positions[c * chunk_points_ + i].cast<double>();
    add(c, std::move(chunk));
  }
}

bool SoftReplica::sample(double tick, double dt) {
  if (!complete()) return false;
  bool moved = false;
  for (std::uint32_t c = 0; c < chunks_.size(); ++c) {
    const auto bracket = chunks_[c].at(tick, dt);
    for (std::uint32_t i = 0; i < size_of(c); ++i) {
      Vec3& x = current_[c * chunk_points_ + i];
      const Vec3 next =
          bracket.from == bracket.to
              ? bracket.from->positions[i]
              : hermite(bracket.from->positions[i], bracket.from->velocities[i], bracket.to->positions[i],
                        bracket.to->velocities[i], bracket.seconds, bracket.share);
      moved |= next != x;
      x = next;
    }
  }
  if (moved)
    for (std::size_t i = 0; i < surface_.size(); ++i)
      surface_[i] = streamed_.map.apply(i, current_.front().data()).cast<float>();
  return moved;
}

}  // namespace prosector
