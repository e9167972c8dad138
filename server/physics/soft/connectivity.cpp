#include "server/physics/soft/connectivity.h"

#include <algorithm>
#include <array>

#include "server/physics/parallel.h"
#include "server/physics/soft/table_rows.h"

namespace prosector {
namespace {

constexpr std::size_t nodes_per_chunk = 256;

}  // namespace

void Connectivity::add(std::span<const std::uint32_t> element) {
  corner_.insert(corner_.end(), element.begin(), element.end());
  corner_begin_.push_back(corner_.size());
  block_begin_.push_back(block_begin_.back() + pair_count(element.size()));
  each_ = size() == 1 || each_ == element.size() ? element.size() : 0;
  if (each_ > 0) return;
  for (std::size_t e = element_.empty() ? 0 : size() - 1; e < size(); ++e)
    element_.resize(corner_begin_[e + 1], static_cast<std::uint32_t>(e));
}

void Connectivity::follow(const MeshEdit& edit) {
  nodes_ += edit.positions.size();
  for (std::size_t i = 0; i < edit.tets.size(); ++i) {
    MeshEdit::Corners element = edit.corners[i];
    std::sort(element.begin(), element.end());
    if (i < edit.corners_before.size())
      std::copy(element.begin(), element.end(), corner_.begin() + 4 * std::ptrdiff_t{edit.tets[i]});
    else
      add(element);
  }
}

void Connectivity::reserve(std::size_t elements, std::size_t corners_each) {
  corner_.reserve(elements * corners_each);
  corner_begin_.reserve(elements + 1);
  block_begin_.reserve(elements + 1);
}

Incidence::Incidence(const Connectivity& elements) : begin_(elements.nodes() + 1, 0) {
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::uint32_t i : elements.element(e)) ++begin_[i + 1];
  }
  for (std::size_t i = 0; i < elements.nodes(); ++i) begin_[i + 1] += begin_[i];
  corner_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  std::uint32_t corner = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::uint32_t i : elements.element(e)) corner_[next[i]++] = corner++;
  }
}

void Incidence::follow(const Connectivity& elements, const MeshEdit& edit) {
  std::vector<char> changed(elements.size(), 0);
  std::vector<std::array<std::uint32_t, 2>> met;  // node and corner, of what changed
  for (const std::uint32_t e : edit.tets) {
    changed[e] = 1;
    auto corner = static_cast<std::uint32_t>(elements.first_corner(e));
    for (const std::uint32_t node : elements.element(e)) met.push_back({node, corner++});
  }
  std::sort(met.begin(), met.end());
  FreshRows<std::uint32_t> rows;
  auto next = met.begin();
  for (const std::uint32_t node : edit.nodes) {
    const std::size_t first = rows.values.size();
    if (node + 1 < begin_.size())
      for (const std::uint32_t corner : corners(node))
        if (!changed[elements.element_of(corner)]) rows.values.push_back(corner);
    for (; next != met.end() && (*next)[0] == node; ++next) rows.values.push_back((*next)[1]);
    std::sort(rows.values.begin() + static_cast<std::ptrdiff_t>(first), rows.values.end());
    rows.counts.push_back(rows.values.size() - first);
  }
  replace_rows(std::span(edit.nodes), rows, begin_, corner_);
}

void Incidence::add(std::span<const Vec3> f, double* g) const {
  parallel_chunks(begin_.size() - 1, nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      Eigen::Map<Vec3> out(g + 3 * i);
      Vec3 sum = out;
      for (std::uint32_t corner : corners(i)) sum += f[corner];
      out = sum;
    }
  });
}

}  // namespace prosector
