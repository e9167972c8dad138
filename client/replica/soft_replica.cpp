#include "client/replica/soft_replica.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/assert.h"
#include "common/error.h"

namespace prosector {
namespace {

std::size_t chunks_of(std::uint32_t points, std::uint32_t chunk_points) {
  return (points + chunk_points - 1) / chunk_points;
}

}  // namespace

SoftReplica::SoftReplica(const SceneBody& body, TriangleMesh rest, StreamedSurface streamed)
    : points_(body.points),
      chunk_points_(body.chunk_points),
      drawn_(rounded(std::move(rest), std::move(streamed))) {
  PROSECTOR_ASSERT(chunk_points_ > 0 && drawn_.streamed.rest.size() == points_ &&
                   drawn_.streamed.map.rows.size() == drawn_.rest.positions.size());
  chunks_.resize(chunks_of(points_, chunk_points_));
  missing_chunks_ = chunks_.size();
  current_.assign(points_, Vec3::Zero());
  surface_.reserve(drawn_.rest.positions.size());
  for (const Vec3& x : drawn_.rest.positions) surface_.push_back(x.cast<float>());
}

std::uint32_t SoftReplica::size_of(std::uint32_t chunk) const {
  PROSECTOR_ASSERT(chunk < chunks_.size());
  return std::min(chunk_points_, points_ - chunk * chunk_points_);
}

void SoftReplica::add(std::uint32_t chunk, Chunk sample) {
  PROSECTOR_ASSERT(sample.positions.size() == size_of(chunk) && sample.velocities.size() == size_of(chunk));
  missing_chunks_ -= chunks_[chunk].empty() ? 1 : 0;
  chunks_[chunk].add(std::move(sample));
}

/// Extends or truncates a chunk of another topology revision to this one's size. Points that the sample lacks
/// take the newest known position and velocity.
void SoftReplica::fill_missing_points(std::uint32_t chunk, Chunk& sample) const {
  PROSECTOR_ASSERT(sample.positions.size() == sample.velocities.size());
  const std::size_t size = size_of(chunk);
  for (std::size_t i = sample.positions.size(); i < size; ++i) {
    sample.positions.push_back(chunks_[chunk].newest().positions[i]);
    sample.velocities.push_back(chunks_[chunk].newest().velocities[i]);
  }
  sample.positions.resize(size);
  sample.velocities.resize(size);
}

bool SoftReplica::add(const SoftState& s) {
  const bool is_later = s.revision > revision_, is_earlier = s.revision < revision_;
  if (s.chunk >= chunks_.size() && is_later) return false;
  const std::size_t count = s.positions.size();
  if (s.chunk >= chunks_.size() || s.first_point != s.chunk * chunk_points_ || count > chunk_points_ ||
      s.velocities.size() != count || (count > size_of(s.chunk) && !is_later) ||
      (count < size_of(s.chunk) && (!is_earlier || chunks_[s.chunk].empty()))) {
    ++dropped_;
    return true;
  }
  const bool whole = count <= size_of(s.chunk);
  Chunk chunk{s.time, s.positions, s.velocities};
  fill_missing_points(s.chunk, chunk);
  for (std::uint32_t i = 0; i < std::min<std::size_t>(count, chunk.positions.size()); ++i)
    chunk.positions[i] += drawn_.streamed.rest[s.first_point + i];
  add(s.chunk, std::move(chunk));
  return whole;
}

bool SoftReplica::add(const Settled& settled) {
  const std::size_t count = settled.positions.size();
  const bool is_later = settled.revision > revision_;
  if ((count > points_ && !is_later) || (count < points_ && settled.revision >= revision_)) {
    ++dropped_;
    return true;
  }
  for (std::uint32_t c = 0; c < chunks_.size(); ++c) {
    const std::size_t begin = std::size_t{c} * chunk_points_;
    if (begin + size_of(c) > count) break;  // the rest belongs to a later revision than the sample's
    Chunk chunk{settled.time, std::vector<Vec3>(size_of(c)), std::vector<Vec3>(size_of(c), Vec3::Zero())};
    for (std::size_t i = 0; i < chunk.positions.size(); ++i)
      chunk.positions[i] = settled.positions[begin + i].cast<double>();
    add(c, std::move(chunk));
  }
  return count <= points_;
}

void SoftReplica::follow(DrawnSurface next, const SurfacePatch& patch, std::uint32_t revision, SimTime time) {
  std::vector<Vec3> where;
  for (const SurfacePatch::Point& point : patch.points) where.push_back(point.now.cast<double>());
  grow(std::move(next), where, revision, time);
}

void SoftReplica::enter(DrawnSurface next, std::uint32_t revision, SimTime time) {
  if (next.streamed.rest.size() < points_)
    throw InputError(fmt::format("topology: {} points after {}", next.streamed.rest.size(), points_));
  const Vec3 shift =
      complete() && points_ > 0 ? Vec3(current_.back() - drawn_.streamed.rest.back()) : Vec3(Vec3::Zero());
  std::vector<Vec3> where;
  for (std::size_t i = points_; i < next.streamed.rest.size(); ++i)
    where.push_back(next.streamed.rest[i] + shift);
  grow(std::move(next), where, revision, time);
}

void SoftReplica::grow(DrawnSurface next, const std::vector<Vec3>& where, std::uint32_t revision,
                       SimTime time) {
  PROSECTOR_ASSERT(next.streamed.rest.size() == points_ + where.size() && current_.size() == points_);
  const bool was_complete = complete();
  const std::uint32_t before = points_;
  points_ = static_cast<std::uint32_t>(next.streamed.rest.size());
  chunks_.resize(chunks_of(points_, chunk_points_));
  missing_chunks_ = static_cast<std::size_t>(
      std::ranges::count_if(chunks_, [](const Track<Chunk>& track) { return track.empty(); }));
  for (std::uint32_t c = before / chunk_points_; c < chunks_.size(); ++c) {
    const auto from = where.begin() + std::max(before, c * chunk_points_) - before;
    const auto to = where.begin() + (c * chunk_points_ + size_of(c)) - before;
    chunks_[c].change_each([&](Chunk& sample) {
      sample.positions.insert(sample.positions.end(), from, to);
      sample.velocities.resize(sample.positions.size(), Vec3::Zero());
    });
    if (chunks_[c].empty() && was_complete)
      add(c, {time, {from, to}, std::vector<Vec3>(static_cast<std::size_t>(to - from), Vec3::Zero())});
  }
  current_.insert(current_.end(), where.begin(), where.end());
  drawn_ = std::move(next);
  for (std::size_t v = surface_.size(); v < drawn_.rest.positions.size(); ++v)
    surface_.push_back(drawn_.rest.positions[v].cast<float>());
  revision_ = revision;
  ++shape_;
  reshaped_ = true;
}

bool SoftReplica::sample(double tick, double dt) {
  if (!complete()) return false;
  bool moved = std::exchange(reshaped_, false);
  for (std::uint32_t c = 0; c < chunks_.size(); ++c) {
    const auto bracket = chunks_[c].at(tick, dt);
    PROSECTOR_ASSERT(bracket.from != nullptr && bracket.to != nullptr);
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
      surface_[i] = drawn_.streamed.map.apply(i, current_.front().data()).cast<float>();
  return moved;
}

}  // namespace prosector
