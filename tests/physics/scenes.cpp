#include "tests/physics/scenes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace prosector::test {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Faces that belong to one tetrahedron only, outwards.
std::vector<Triangle> boundary(const TetMesh& mesh) {
  std::map<Triangle, std::pair<int, Triangle>> faces;
  for (const auto& t : mesh.tets)
    for (const Triangle& f : {Triangle{t[0], t[2], t[1]}, Triangle{t[0], t[1], t[3]},
                              Triangle{t[1], t[2], t[3]}, Triangle{t[0], t[3], t[2]}}) {
      Triangle key = f;
      std::sort(key.begin(), key.end());
      auto& entry = faces[key];
      ++entry.first;
      entry.second = f;
    }
  std::vector<Triangle> out;
  for (const auto& [key, entry] : faces)
    if (entry.first == 1) out.push_back(entry.second);
  return out;
}

void drop_loose_nodes(TetMesh& mesh) {
  std::vector<std::uint32_t> place(mesh.positions.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const std::uint32_t node : tet) place[node] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    mesh.positions[kept] = mesh.positions[i];
    place[i] = kept++;
  }
  mesh.positions.resize(kept);
  for (auto& tet : mesh.tets)
    for (std::uint32_t& node : tet) node = place[node];
}

}  // namespace

Anatomy make_block(const Vec3& size, const std::array<int, 3>& cells,
                   const std::function<bool(int, int, int)>& hollow) {
  Anatomy out;
  const auto [nx, ny, nz] = cells;
  const auto node = [&, nx = nx, ny = ny](int i, int j, int k) {
    return static_cast<std::uint32_t>((k * (ny + 1) + j) * (nx + 1) + i);
  };
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i)
        out.tets.positions.push_back(
            size.cwiseProduct(Vec3(1.0 * i / nx - 0.5, 1.0 * j / ny - 0.5, 1.0 * k / nz - 0.5)));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        if (hollow && hollow(i, j, k)) continue;
        std::array<int, 3> axes = {0, 1, 2};
        do {
          std::array<int, 3> at = {i, j, k};
          std::array<std::uint32_t, 4> tet{node(i, j, k)};
          for (std::size_t a = 0; a < 3; ++a) {
            ++at[static_cast<std::size_t>(axes[a])];
            tet[a + 1] = node(at[0], at[1], at[2]);
          }
          const Vec3& o = out.tets.positions[tet[0]];
          const Vec3 a = out.tets.positions[tet[1]] - o, b = out.tets.positions[tet[2]] - o,
                     c = out.tets.positions[tet[3]] - o;
          if (a.dot(b.cross(c)) < 0) std::swap(tet[1], tet[2]);
          out.tets.tets.push_back(tet);
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  drop_loose_nodes(out.tets);
  return with_boundary(std::move(out.tets));
}

Anatomy with_boundary(TetMesh mesh) {
  Anatomy out;
  out.tets = std::move(mesh);
  std::map<std::uint32_t, std::uint32_t> vertex;
  for (Triangle t : boundary(out.tets)) {
    for (std::uint32_t& corner : t) {
      const auto [at, fresh] = vertex.emplace(corner, static_cast<std::uint32_t>(vertex.size()));
      if (fresh) {
        out.surface.positions.push_back(out.tets.positions[corner]);
        out.embedding.rows.push_back({{corner, corner, corner, corner}, {1, 0, 0, 0}});
      }
      corner = at->second;
    }
    out.surface.triangles.push_back(t);
  }
  return out;
}

RigidDesc part_body(const std::string& name, const std::string& shape, const Vec3& size, const Vec3& at,
                    double density) {
  RigidDesc out;
  out.name = name;
  PartDesc part;
  part.shape = shape;
  part.size = size;
  out.geometry.parts = {part};
  out.pose.p = at;
  out.material.density = density;
  return out;
}

RigidDesc table() {
  RigidDesc out = part_body("table", "box", {2, 0.1, 2}, {0, -0.05, 0});
  out.fixed = true;
  return out;
}

SoftDesc block(const std::string& name) {
  SoftDesc out;
  out.name = name;
  out.geometry.shape = "block";
  out.geometry.size = {0.1, 0.06, 0.1};
  out.geometry.cell = 0.02;
  out.geometry.surface_cell = 0.02;
  out.pose.p = {0, 0.03, 0};
  return out;
}

CompileOptions options(int threads) {
  CompileOptions out;
  out.threads = threads;
  out.anatomy = [](const SoftDesc& desc) -> std::optional<Anatomy> {
    if (!desc.geometry.is_solid()) return std::nullopt;
    std::array<int, 3> cells;
    for (std::size_t a = 0; a < 3; ++a)
      cells[a] = std::max(1, static_cast<int>(std::lround(desc.geometry.size[static_cast<Eigen::Index>(a)] /
                                                          desc.geometry.cell)));
    Anatomy made = make_block(desc.geometry.size, cells);
    for (Vec3& x : made.tets.positions) x = desc.pose * x;
    for (Vec3& x : made.surface.positions) x = desc.pose * x;
    return made;
  };
  return out;
}

void run(Simulation& simulation, int ticks, const TickInput& input) {
  TickInput now = input;
  for (int i = 0; i < ticks; ++i) {
    simulation.step(now);
    now.events.clear();
  }
}

TickInput target(const Vec3& at, const Quat& q, double flexion) {
  HandTarget t;
  t.participant = somebody;
  t.target = {at, q};
  t.flexion.fill(flexion);
  TickInput out;
  out.targets.push_back(t);
  return out;
}

TickInput event(HandEvent::Kind kind, const Vec3& at) {
  TickInput out = target(at);
  out.events.push_back({kind, somebody, right_hand, 0});
  return out;
}

double energy(const StepReport& report) {
  return report.kinetic_energy + report.elastic_energy + report.potential_energy;
}

TickInput appear(const Vec3& at, const Quat& q) {
  TickInput out = target(at, q);
  out.events.push_back({HandEvent::Kind::appear, somebody, right_hand, 0});
  return out;
}

}  // namespace prosector::test
