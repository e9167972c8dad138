#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

Kept Kept::all(std::size_t before, std::size_t now) {
  return {{{0, 0, static_cast<std::uint32_t>(before)}}, before, now};
}

void Kept::add(std::uint32_t from, std::uint32_t to) {
  if (!runs.empty() && runs.back().from + runs.back().count == from &&
      runs.back().to + runs.back().count == to)
    ++runs.back().count;
  else
    runs.push_back({from, to, 1});
}

std::size_t Kept::unmoved() const {
  return runs.empty() || runs.front().from > 0 || runs.front().to > 0 ? 0 : runs.front().count;
}

std::vector<std::uint32_t> Kept::destinations() const {
  std::vector<std::uint32_t> out(before, none);
  for (const Run& run : runs)
    for (std::uint32_t i = 0; i < run.count; ++i) out[run.from + i] = run.to + i;
  return out;
}

std::vector<std::uint32_t> Kept::origins() const {
  std::vector<std::uint32_t> out(now, none);
  for (const Run& run : runs)
    for (std::uint32_t i = 0; i < run.count; ++i) out[run.to + i] = run.from + i;
  return out;
}

void Kept::carry(VecX& values) const {
  VecX out(static_cast<Eigen::Index>(now));
  for (const Run& run : runs) out.segment(run.to, run.count) = values.segment(run.from, run.count);
  values = std::move(out);
}

void apply(const MeshEdit& edit, TetMesh& mesh) {
  edit.kept_nodes.carry(mesh.positions);
  for (std::size_t i = 0; i < edit.made_nodes.size(); ++i)
    mesh.positions[edit.made_nodes[i]] = edit.positions[i];
  edit.kept_tets.carry(mesh.tets);
  if (!edit.kept_nodes.all_unmoved()) {
    const std::vector<std::uint32_t> now = edit.kept_nodes.destinations();
    for (MeshEdit::Corners& corners : mesh.tets)
      for (std::uint32_t& corner : corners) corner = now[corner];
  }
  for (std::size_t i = 0; i < edit.tets.size(); ++i) mesh.tets[edit.tets[i]] = edit.corners[i];
}

}  // namespace prosector::soft
