#include "server/physics/mechanics/soft/base/connectivity.h"

#include <algorithm>
#include <functional>
#include <iterator>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/table_rows.h"

namespace prosector::soft {
namespace {

constexpr std::size_t nodes_per_chunk = 256;

}  // namespace

void Connectivity::add(std::span<const std::uint32_t> element) {
  corner_.insert(corner_.end(), element.begin(), element.end());
  corner_begin_.push_back(corner_.size());
  block_begin_.push_back(block_begin_.back() + pair_count(element.size()));
  each_ = size() == 1 || each_ == element.size() ? element.size() : 0;
  if (each_ == 0) list_elements_of_corners(size() - 1);
}

std::span<std::uint32_t> Connectivity::grow(std::size_t elements, std::size_t corners_each) {
  const std::size_t first = size(), corner = corner_.size(), block = block_begin_.back();
  if (elements == 0) return {};
  corner_.resize(corner + elements * corners_each);
  corner_begin_.resize(first + elements + 1);
  block_begin_.resize(first + elements + 1);
  for (std::size_t e = 1; e <= elements; ++e) {
    corner_begin_[first + e] = corner + e * corners_each;
    block_begin_[first + e] = block + e * pair_count(corners_each);
  }
  each_ = first == 0 || each_ == corners_each ? corners_each : 0;
  if (each_ == 0) list_elements_of_corners(first);
  return std::span(corner_).subspan(corner);
}

void Connectivity::append(const Connectivity& elements) {
  if (elements.each_ == 0) {
    for (std::size_t e = 0; e < elements.size(); ++e) add(elements.element(e));
    return;
  }
  std::ranges::copy(elements.corner_, grow(elements.size(), elements.each_).begin());
}

void Connectivity::clear(std::size_t nodes) {
  nodes_ = nodes;
  corner_.clear();
  corner_begin_.assign(1, 0);
  block_begin_.assign(1, 0);
  element_.clear();
  each_ = 0;
}

/// Lists the elements of corners from `first` on; from 0 on if all elements so far had equally many corners.
void Connectivity::list_elements_of_corners(std::size_t first) {
  for (std::size_t e = element_.empty() ? 0 : first; e < size(); ++e)
    element_.resize(corner_begin_[e + 1], static_cast<std::uint32_t>(e));
}

void Connectivity::follow(const MeshEdit& edit) {
  nodes_ = edit.kept_nodes.now;
  edit.kept_tets.carry(corner_, each_);
  if (!edit.kept_nodes.all_unmoved()) {
    const std::vector<std::uint32_t> now = edit.kept_nodes.destinations();
    for (std::uint32_t& node : corner_) node = now[node];
  }
  for (std::size_t i = 0; i < edit.tets.size(); ++i) {
    MeshEdit::Corners element = edit.corners[i];
    std::sort(element.begin(), element.end());
    const auto middles = edit.middles.begin() + static_cast<std::ptrdiff_t>((each_ - 4) * i);
    std::copy_n(middles, each_ - 4,
                std::copy(element.begin(), element.end(),
                          corner_.begin() + static_cast<std::ptrdiff_t>(each_ * edit.tets[i])));
  }
  const std::size_t known = std::min(size(), edit.kept_tets.now);
  corner_begin_.resize(edit.kept_tets.now + 1);
  block_begin_.resize(edit.kept_tets.now + 1);
  for (std::size_t e = known; e < size(); ++e) {
    corner_begin_[e + 1] = corner_begin_[e] + each_;
    block_begin_[e + 1] = block_begin_[e] + pair_count(each_);
  }
}

Incidence::Incidence(const Connectivity& elements)
    : begin_(elements.nodes() + 1, 0), corner_(elements.corners()) {
  const std::span<const std::uint32_t> nodes = elements.corner_nodes();
  for (const std::uint32_t i : nodes) ++begin_[i + 1];
  for (std::size_t i = 0; i < elements.nodes(); ++i) begin_[i + 1] += begin_[i];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t corner = 0; corner < nodes.size(); ++corner) corner_[next[nodes[corner]]++] = corner;
}

void Incidence::follow(const Connectivity& elements, const MeshEdit& edit) {
  const auto each = static_cast<std::uint32_t>(elements.corners_each());
  if (each < 4 || elements.size() != edit.kept_tets.now) {
    *this = Incidence(elements);
    return;
  }
  std::vector<char> changed(elements.size(), 0);
  std::vector<std::size_t> met_begin(elements.nodes() + 1, 0);  // by node: corners of changed elements
  for (const std::uint32_t e : edit.tets) {
    changed[e] = 1;
    for (const std::uint32_t node : elements.element(e)) ++met_begin[node + 1];
  }
  for (std::size_t i = 0; i < elements.nodes(); ++i) met_begin[i + 1] += met_begin[i];
  std::vector<std::uint32_t> met(met_begin.back());
  std::vector<std::size_t> next(met_begin.begin(), met_begin.end() - 1);
  for (const std::uint32_t e : edit.tets) {
    auto corner = static_cast<std::uint32_t>(elements.first_corner(e));
    for (const std::uint32_t node : elements.element(e)) met[next[node]++] = corner++;
  }
  const std::vector<std::uint32_t> origin = edit.kept_nodes.origins(), now = edit.kept_tets.destinations();
  FreshRows<std::uint32_t> rows;
  std::vector<std::uint32_t> stayed;
  for (const std::uint32_t node : edit.nodes) {
    stayed.clear();
    if (origin[node] != Kept::none)
      for (const std::uint32_t corner : corners(origin[node]))
        if (const std::uint32_t e = now[corner / each]; e != Kept::none && !changed[e])
          stayed.push_back(each * e + corner % each);
    const auto fresh = std::span(met).subspan(met_begin[node], met_begin[node + 1] - met_begin[node]);
    std::merge(stayed.begin(), stayed.end(), fresh.begin(), fresh.end(), std::back_inserter(rows.values));
    rows.counts.push_back(stayed.size() + fresh.size());
  }
  const auto renumbered = [&](std::uint32_t corner) { return each * now[corner / each] + corner % each; };
  if (edit.kept_tets.all_unmoved())
    replace_rows(edit.kept_nodes, edit.nodes, rows, std::identity{}, begin_, corner_);
  else
    replace_rows(edit.kept_nodes, edit.nodes, rows, renumbered, begin_, corner_);
}

void Incidence::add(std::span<const Vec3> f, double* g) const {
  parallel_short_chunks(begin_.size() - 1, nodes_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t i = first; i < last; ++i) {
                            Eigen::Map<Vec3> out(g + 3 * i);
                            Vec3 sum = out;
                            for (std::uint32_t corner : corners(i)) sum += f[corner];
                            out = sum;
                          }
                        });
}

}  // namespace prosector::soft
