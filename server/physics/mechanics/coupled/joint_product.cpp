#include "server/physics/mechanics/coupled/joint_product.h"

#include <utility>

#include "common/assert.h"
#include "server/physics/base/parallel.h"

namespace prosector::coupled {
namespace {

constexpr std::size_t rows_at_once = 256, nodes_at_once = 128, bodies_at_once = 16;

Vec3 moved_body(std::uint32_t at, const Vec3& arm, const VecX& p) {
  const Vec3 rotation = p.segment<3>(at + 3);
  return p.segment<3>(at) + rotation.cross(arm);
}

}  // namespace

void JointProduct::set(const IslandLayout& layout, std::span<const Joint* const> joints) {
  rows_.clear();
  hanging_.clear();
  const auto place = [&](const JointSide& side) {
    return side.rigid < 0 ? none : static_cast<std::uint32_t>(side.rigid);
  };
  const auto here = [&] { return static_cast<std::uint32_t>(hanging_.size()); };
  for (const Joint* joint : joints) {
    Row row;
    row.a = here();
    pack_side(joint->a);
    row.b = here();
    pack_side(joint->b);
    row.end = here();
    row.body_a = place(joint->a);
    row.body_b = place(joint->b);
    row.arm_a = joint->a.arm;
    row.arm_b = joint->b.arm;
    row.D = joint->D;
    rows_.push_back(row);
  }
  force_.resize(rows_.size());
  list_nodes(layout);
  list_bodies(layout);
}

void JointProduct::pack_side(const JointSide& side) {
  for (std::size_t k = 0; k < side.nodes; ++k)
    hanging_.push_back({static_cast<std::uint32_t>(side.offset[k]), side.weight[k]});
}

/// Lists the contributions to each node, by counting sort.
void JointProduct::list_nodes(const IslandLayout& layout) {
  count_.assign(static_cast<std::size_t>(layout.rigid_begin / 3) + 1, 0);
  for (const Hanging& h : hanging_) ++count_[h.at / 3];
  nodes_.at.clear();
  nodes_.begin.clear();
  std::uint32_t sum = 0;
  for (std::uint32_t node = 0; node + 1 < count_.size(); ++node) {
    if (count_[node] == 0) continue;
    nodes_.at.push_back(3 * node);
    nodes_.begin.push_back(sum);
    sum += std::exchange(count_[node], sum);
  }
  nodes_.begin.push_back(sum);
  shares_.resize(sum);
  for (std::uint32_t r = 0; r < rows_.size(); ++r)
    for (std::uint32_t i = rows_[r].a; i < rows_[r].end; ++i) {
      const Hanging& h = hanging_[i];
      shares_[count_[h.at / 3]++] = {r, i < rows_[r].b ? h.weight : -h.weight};
    }
}

void JointProduct::list_bodies(const IslandLayout& layout) {
  const auto first = static_cast<std::uint32_t>(layout.rigid_begin);
  count_.assign(static_cast<std::size_t>(layout.size - layout.rigid_begin) / 6 + 1, 0);
  for (const Row& row : rows_)
    for (const std::uint32_t body : {row.body_a, row.body_b})
      if (body != none) ++count_[(body - first) / 6];
  bodies_.at.clear();
  bodies_.begin.clear();
  std::uint32_t sum = 0;
  for (std::uint32_t body = 0; body + 1 < count_.size(); ++body) {
    bodies_.at.push_back(first + 6 * body);
    bodies_.begin.push_back(sum);
    sum += std::exchange(count_[body], sum);
  }
  bodies_.begin.push_back(sum);
  moments_.resize(sum);
  for (std::uint32_t r = 0; r < rows_.size(); ++r) {
    if (rows_[r].body_a != none) moments_[count_[(rows_[r].body_a - first) / 6]++] = {r, false};
    if (rows_[r].body_b != none) moments_[count_[(rows_[r].body_b - first) / 6]++] = {r, true};
  }
}

template <class F>
void JointProduct::for_rows(const F& f) const {
  parallel_short_chunks(rows_.size(), rows_at_once, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t r = first; r < last; ++r) force_[r] = f(rows_[r]);
  });
}

Vec3 JointProduct::moved_nodes(std::uint32_t begin, std::uint32_t end, const VecX& p) const {
  Vec3 u = Vec3::Zero();
  for (std::uint32_t i = begin; i < end; ++i) u += hanging_[i].weight * p.segment<3>(hanging_[i].at);
  return u;
}

void JointProduct::add_to_nodes(VecX& out) const {
  parallel_short_chunks(nodes_.at.size(), nodes_at_once,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t n = first; n < last; ++n) {
                            auto sum = out.segment<3>(nodes_.at[n]);
                            for (std::uint32_t i = nodes_.begin[n]; i < nodes_.begin[n + 1]; ++i)
                              sum += shares_[i].weight * force_[shares_[i].row];
                          }
                        });
}

void JointProduct::add_to_bodies(VecX& out) const {
  parallel_short_chunks(
      bodies_.at.size(), bodies_at_once, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t n = first; n < last; ++n) {
          auto force = out.segment<3>(bodies_.at[n]), moment = out.segment<3>(bodies_.at[n] + 3);
          for (std::uint32_t i = bodies_.begin[n]; i < bodies_.begin[n + 1]; ++i) {
            const auto [r, is_b] = moments_[i];
            const Vec3 f = is_b ? Vec3(-force_[r]) : force_[r];
            force += f;
            moment += (is_b ? rows_[r].arm_b : rows_[r].arm_a).cross(f);
          }
        }
      });
}

void JointProduct::multiply(const VecX& p, VecX& Hp) const {
  PROSECTOR_ASSERT(p.size() == Hp.size());
  for_rows([&](const Row& row) -> Vec3 {
    Vec3 a = moved_nodes(row.a, row.b, p), b = moved_nodes(row.b, row.end, p);
    if (row.body_a != none) a += moved_body(row.body_a, row.arm_a, p);
    if (row.body_b != none) b += moved_body(row.body_b, row.arm_b, p);
    return row.D * (a - b);
  });
  add_to_nodes(Hp);
  add_to_bodies(Hp);
}

void JointProduct::subtract_from_nodes(const VecX& z, VecX& g) const {
  PROSECTOR_ASSERT(z.size() == g.size());
  for_rows([&](const Row& row) -> Vec3 {
    if (row.a == row.end || (row.body_a == none && row.body_b == none)) return Vec3::Zero();
    const Vec3 a = row.body_a != none ? moved_body(row.body_a, row.arm_a, z) : Vec3(Vec3::Zero());
    const Vec3 b = row.body_b != none ? moved_body(row.body_b, row.arm_b, z) : Vec3(Vec3::Zero());
    return row.D * (b - a);
  });
  add_to_nodes(g);
}

void JointProduct::subtract_from_bodies(const VecX& p, VecX& g) const {
  PROSECTOR_ASSERT(p.size() == g.size());
  for_rows([&](const Row& row) -> Vec3 {
    return row.D * (moved_nodes(row.b, row.end, p) - moved_nodes(row.a, row.b, p));
  });
  add_to_bodies(g);
}

}  // namespace prosector::coupled
