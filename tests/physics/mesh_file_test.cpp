// Bodies whose tetrahedra come from a file, whose boundary is then the surface that is touched.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/anatomy/kuhn_box.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/under_ball.h"

namespace prosector::test {
namespace {

/// A slab of 60 × 30 × 60 mm as a Gmsh file, removed when this goes.
class SlabFile {
 public:
  SlabFile() : path_(std::filesystem::temp_directory_path() / ("slab" + std::to_string(getpid()) + ".msh")) {
    const TetMesh mesh = kuhn_box({0.06, 0.03, 0.06}, 8, 4, 8);
    std::ofstream out(path_);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.positions.size() << "\n";
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      out << i + 1 << " " << mesh.positions[i].transpose() << "\n";
    out << "$EndNodes\n$Elements\n" << mesh.tets.size() << "\n";
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      out << t + 1 << " 4 2 0 1";
      for (const std::uint32_t node : mesh.tets[t]) out << " " << node + 1;
      out << "\n";
    }
    out << "$EndElements\n";
  }
  ~SlabFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

constexpr double radius = 0.02, depth = 0.002, youngs_modulus = 5000;

/// N, of a ball driven `depth` into the middle of the slab, held at its bottom, once all is still.
double force_on_ball(const std::string& mesh, const std::string& element) {
  SoftDesc slab;
  slab.name = "slab";
  slab.geometry.mesh = mesh;
  slab.configuration.element = element;
  slab.material.youngs_modulus = youngs_modulus;
  slab.material.poisson_ratio = 0.3;
  slab.geometry.cell = slab.geometry.surface_cell = 0.0075;
  slab.pose.p = {-0.03, 0, -0.03};
  slab.configuration.solver_iterations = 500;
  slab.contact.friction = 0;
  const double flat = 1000;
  slab.attach = {{{0, -flat, 0}, flat + 1e-4, 1e12}};
  SceneDesc scene = under_ball(slab, radius, {0, 0.03 + radius + 0.001, 0});
  scene.contact_stiffness = 100;
  CompileOptions compiled;
  compiled.threads = 1;
  Simulation simulation(scene, compiled);
  for (int tick = 1; tick <= 60; ++tick) {
    const double down = std::min(1.0, tick / 20.0) * (0.001 + depth);
    simulation.step(ball_at({0, 0.03 + radius + 0.001 - down, 0}));
  }
  return pressing_force(simulation);
}

// A bonded slab resists more than the half-space of Hertz. Quadratic elements whose corners alone were loaded
// gave way where loads were, since a corner carries next to nothing of an even pressure.
TEST(MeshFile, QuadraticElementsBearABallAsTheContinuumDoes) {
  const SlabFile file;
  const double hertz =
      4. / 3 * youngs_modulus / (1 - 0.3 * 0.3) * std::sqrt(radius) * std::pow(depth, 1.5);  // N
  const double force = force_on_ball(file.path(), "tet10");
  EXPECT_GT(force, 0.95 * hertz);
  EXPECT_LT(force, 1.35 * hertz);
}

}  // namespace
}  // namespace prosector::test
