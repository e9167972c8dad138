#include "server/session/sending/soft_sender.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector {
namespace {

bool is_same(const VecX& a, const VecX& b) {
  return &a == &b || (a.size() == b.size() && a == b);
}

}  // namespace

SoftSender::SoftSender(BodyId body, double tick_rate) : body_(body), dt_(1 / tick_rate) {}

void SoftSender::update(const SoftSnapshot& now, SimTime time, bool everything, std::vector<Message>& out) {
  PROSECTOR_ASSERT(now.stream != nullptr && now.x != nullptr && now.v != nullptr &&
                   now.x->size() == now.v->size());
  if (stream_ != now.stream) {
    stream_ = now.stream;
    grow();
  }
  const bool rewound = time.epoch != epoch_;  // clients drop the body's state
  epoch_ = time.epoch;
  if (rewound) settled_.reset();
  if (now.asleep && settled_ != nullptr && is_same(*settled_, *now.x)) return;
  place(now);
  if (now.asleep) return settle(now, time, out);
  settled_.reset();
  const std::uint32_t chunks = stream_->chunks();
  if (chunks == 0) return;
  const auto refreshed = static_cast<std::uint32_t>((chunks + soft_refresh_ticks - 1) / soft_refresh_ticks);
  for (std::uint32_t c = 0; c < chunks; ++c) {
    const bool due = (c + chunks - cursor_) % chunks < refreshed;
    if (everything || rewound || due || end(c) > known_points_ || changed(c))
      out.push_back(send(c, time, now.revision));
  }
  cursor_ = (cursor_ + refreshed) % chunks;
  known_points_ = stream_->points;
}

/// Makes room for points that a new revision appended.
void SoftSender::grow() {
  PROSECTOR_ASSERT(stream_->points >= x_.size());
  for (auto* v : {&x_, &v_, &sent_x_, &sent_v_}) v->resize(stream_->points, Vec3::Zero());
  settled_.reset();
}

void SoftSender::place(const SoftSnapshot& now) {
  const std::vector<std::uint32_t>& leaders = stream_->leaders;
  const auto is_gone = [&](std::uint32_t i) { return !leaders.empty() && leaders[i] != i; };
  const SparseMap& sources = now.sources ? *now.sources : stream_->sources;
  PROSECTOR_ASSERT(sources.rows.size() == stream_->points && stream_->surface.rest.size() == stream_->points);
  PROSECTOR_ASSERT(leaders.empty() || leaders.size() == stream_->points);
  for (std::uint32_t i = 0; i < stream_->points; ++i) {
    if (is_gone(i)) continue;
    x_[i] = sources.apply(i, now.x->data());
    v_[i] = sources.apply(i, now.v->data());
  }
  const std::vector<Vec3>& rest = stream_->surface.rest;
  for (std::uint32_t i = 0; i < leaders.size(); ++i) {
    if (!is_gone(i)) continue;
    const bool alone = leaders[i] >= stream_->points;
    x_[i] = alone ? rest[i] : Vec3(rest[i] + x_[leaders[i]] - rest[leaders[i]]);
    v_[i] = alone ? Vec3(Vec3::Zero()) : v_[leaders[i]];
  }
}

void SoftSender::settle(const SoftSnapshot& now, SimTime time, std::vector<Message>& out) {
  PROSECTOR_ASSERT(x_.size() == stream_->points && now.asleep);
  Settled settled;
  settled.body = body_;
  settled.time = time;
  settled.revision = now.revision;
  settled.positions.reserve(x_.size());
  StateHasher hasher;
  for (const Vec3& x : x_) {
    const Eigen::Vector3f& f = settled.positions.emplace_back(x.cast<float>());
    hasher.add(std::as_bytes(std::span<const float>(f.data(), 3)));
  }
  settled.hash = hasher.digest();
  out.push_back(std::move(settled));
  settled_ = now.x;
  sent_x_ = x_;
  std::fill(sent_v_.begin(), sent_v_.end(), Vec3::Zero());
  known_points_ = stream_->points;
}

bool SoftSender::changed(std::uint32_t chunk) const {
  for (std::uint32_t i = begin(chunk); i < end(chunk); ++i) {
    if ((x_[i] - sent_x_[i]).squaredNorm() > soft_send_threshold * soft_send_threshold) return true;
    if ((v_[i] - sent_v_[i]).norm() * dt_ > soft_send_threshold) return true;
  }
  return false;
}

std::uint32_t SoftSender::end(std::uint32_t chunk) const {
  return std::min(begin(chunk) + stream_->chunk_points, stream_->points);
}

SoftState SoftSender::send(std::uint32_t chunk, SimTime time, std::uint32_t revision) {
  PROSECTOR_ASSERT(chunk < stream_->chunks());
  const auto first = static_cast<std::ptrdiff_t>(begin(chunk)),
             last = static_cast<std::ptrdiff_t>(end(chunk));
  SoftState out;
  out.body = body_;
  out.chunk = chunk;
  out.time = time;
  out.revision = revision;
  out.first_point = begin(chunk);
  for (std::uint32_t i = begin(chunk); i < end(chunk); ++i)
    out.positions.push_back(x_[i] - stream_->surface.rest[i]);
  out.velocities.assign(v_.begin() + first, v_.begin() + last);
  std::copy(x_.begin() + first, x_.begin() + last, sent_x_.begin() + first);
  std::copy(v_.begin() + first, v_.begin() + last, sent_v_.begin() + first);
  return out;
}

}  // namespace prosector
