#include "tests/bench/bullet_specimen.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableLagrangianForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "common/error.h"
#include "server/physics/mechanics/soft/elements/tet4.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {
namespace {

constexpr const char* classic = "bullet_classic";
constexpr const char* linear = "bullet_deformable_linear";
constexpr const char* neo_hookean = "bullet_deformable_neo_hookean";

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

Vec3 from_bullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

/// A world with one soft body. Members are declared so that Bullet's objects are destroyed in the required
/// order.
class BulletSpecimen final : public Specimen {
 public:
  BulletSpecimen(const BulletRung& rung, const TestPiece& piece)
      : piece_(piece), dispatcher_(&configuration_) {
    make_world(rung.model == classic);
    make_body();
    if (rung.model == classic) {
      add_links();
      body_->m_cfg.piterations = rung.iterations;
      static_cast<btSoftRigidDynamicsWorld&>(*world_).addSoftBody(body_.get());
    } else {
      add_elements(rung.model);
    }
    body_->setActivationState(DISABLE_DEACTIVATION);
  }

  ~BulletSpecimen() override {
    if (deformable_) {
      deformable_->removeSoftBody(body_.get());
    } else {
      static_cast<btSoftRigidDynamicsWorld&>(*world_).removeSoftBody(body_.get());
    }
  }

  std::size_t elements() const override { return piece_.mesh.tets.size(); }
  const VecX& node_mass() const override { return mass_; }
  VecX rest() const override { return rest_; }
  VecX positions() const override {
    return read([](const btSoftBody::Node& node) { return node.m_x; });
  }
  VecX velocities() const override {
    return read([](const btSoftBody::Node& node) { return node.m_v; });
  }

  void set_motion(const VecX& x, const VecX& v) override {
    for (int i = 0; i < body_->m_nodes.size(); ++i) {
      btSoftBody::Node& node = body_->m_nodes[i];
      node.m_x = node.m_q = to_bullet(x.segment<3>(3 * i));
      node.m_v = node.m_vn = to_bullet(v.segment<3>(3 * i));
    }
  }

  StepFigures step(double dt, const Vec3& gravity) override {
    if (deformable_) {
      gravity_->m_gravity = to_bullet(gravity);
    } else {
      body_->getWorldInfo()->m_gravity = to_bullet(gravity);
    }
    world_->stepSimulation(static_cast<btScalar>(dt), 0);
    const auto left = static_cast<btScalar>(1 / (1 + piece_.damping_mass * dt));
    for (int i = 0; i < body_->m_nodes.size(); ++i) body_->m_nodes[i].m_v *= left;
    StepFigures figures;
    figures.residual = std::numeric_limits<double>::quiet_NaN();
    return figures;
  }

  double elastic_energy() override { return std::numeric_limits<double>::quiet_NaN(); }

 private:
  void make_world(bool is_classic) {
    if (is_classic) {
      constraints_ = std::make_unique<btSequentialImpulseConstraintSolver>();
      world_ = std::make_unique<btSoftRigidDynamicsWorld>(&dispatcher_, &broadphase_, constraints_.get(),
                                                          &configuration_);
      info_ = &static_cast<btSoftRigidDynamicsWorld&>(*world_).getWorldInfo();
    } else {
      soft_solver_ = std::make_unique<btDeformableBodySolver>();
      auto constraints = std::make_unique<btDeformableMultiBodyConstraintSolver>();
      constraints->setDeformableSolver(soft_solver_.get());
      auto world = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
          &dispatcher_, &broadphase_, constraints.get(), &configuration_, soft_solver_.get());
      world->setImplicit(true);
      world->setLineSearch(false);
      world->setUseProjection(true);  // without it the solver stops before such a light body moves
      deformable_ = world.get();
      info_ = &world->getWorldInfo();
      constraints_ = std::move(constraints);
      world_ = std::move(world);
    }
    info_->m_dispatcher = &dispatcher_;
    info_->m_broadphase = &broadphase_;
    info_->m_sparsesdf.Initialize();
  }

  void make_body() {
    const std::size_t n = piece_.mesh.positions.size();
    mass_ = piece_.density * soft::Tet4Elements::lumped_volume(piece_.mesh);
    rest_.resize(static_cast<Eigen::Index>(3 * n));
    std::vector<btVector3> x;
    std::vector<btScalar> m;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& place = piece_.mesh.positions[i];
      const auto k = static_cast<Eigen::Index>(i);
      rest_.segment<3>(3 * k) = place;
      const bool held = piece_.clamped_axis >= 0 && std::abs(place[piece_.clamped_axis]) < 1e-9;
      x.push_back(to_bullet(place));
      m.push_back(held ? 0 : static_cast<btScalar>(mass_[k]));
    }
    body_ = std::make_unique<btSoftBody>(info_, static_cast<int>(n), x.data(), m.data());
    body_->m_cfg.collisions = 0;
  }

  void add_links() {
    body_->m_materials[0]->m_kLST = 1;
    std::set<std::pair<int, int>> edges;
    for (const auto& tet : piece_.mesh.tets) {
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const int one = static_cast<int>(tet[a]), other = static_cast<int>(tet[b]);
          edges.emplace(std::min(one, other), std::max(one, other));
        }
      }
    }
    for (const auto& [a, b] : edges) body_->appendLink(a, b);
    body_->randomizeConstraints();
    body_->updateConstants();  // sets the links' rest lengths to the current ones
    body_->m_bUpdateRtCst = false;
  }

  void add_elements(const std::string& model) {
    for (const auto& t : piece_.mesh.tets) {
      body_->appendTetra(static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]),
                         static_cast<int>(t[3]));
    }
    body_->initializeDmInverse();
    body_->m_tetraScratches.resize(body_->m_tetras.size());
    body_->m_tetraScratchesTn.resize(body_->m_tetras.size());
    body_->setSelfCollision(false);
    deformable_->addSoftBody(body_.get());
    const soft::Lame c = soft::lame(piece_.youngs_modulus, piece_.poisson_ratio);
    const auto mu = static_cast<btScalar>(c.mu), lambda = static_cast<btScalar>(c.lambda),
               damping = static_cast<btScalar>(piece_.damping_stiffness);
    if (model == linear) {
      elastic_ = std::make_unique<btDeformableLinearElasticityForce>(mu, lambda, btScalar(0), damping);
    } else {
      elastic_ = std::make_unique<btDeformableNeoHookeanForce>(mu, lambda, damping);
    }
    gravity_ = std::make_unique<btDeformableGravityForce>(btVector3(0, 0, 0));
    deformable_->addForce(body_.get(), elastic_.get());
    deformable_->addForce(body_.get(), gravity_.get());
  }

  template <class F>
  VecX read(const F& f) const {
    VecX values(rest_.size());
    for (int i = 0; i < body_->m_nodes.size(); ++i)
      values.segment<3>(3 * i) = from_bullet(f(body_->m_nodes[i]));
    return values;
  }

  TestPiece piece_;
  VecX mass_, rest_;
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  std::unique_ptr<btDeformableBodySolver> soft_solver_;
  std::unique_ptr<btConstraintSolver> constraints_;
  std::unique_ptr<btDeformableLagrangianForce> elastic_;
  std::unique_ptr<btDeformableGravityForce> gravity_;
  btSoftBodyWorldInfo* info_ = nullptr;
  btDeformableMultiBodyDynamicsWorld* deformable_ = nullptr;
  std::unique_ptr<btDynamicsWorld> world_;
  std::unique_ptr<btSoftBody> body_;
};

}  // namespace

std::vector<BulletRung> bullet_rungs() {
  return {{classic, 1}, {classic, 10}, {classic, 100}, {linear, 0}, {neo_hookean, 0}};
}

ReportRow settings(const BulletRung& rung) {
  return {{"model", rung.model},
          {"element", "tet4"},
          {"integrator", rung.model == classic ? "position_based" : "implicit_euler"},
          {"solver", rung.model == classic ? "gauss_seidel" : "cg"},
          {"newton_iterations", nullptr},
          {"solver_iterations", rung.iterations > 0 ? nlohmann::ordered_json(rung.iterations) : nullptr},
          {"solver_tolerance", nullptr}};
}

std::unique_ptr<Specimen> make_specimen(const BulletRung& rung, const TestPiece& piece) {
  return std::make_unique<BulletSpecimen>(rung, piece);
}

}  // namespace prosector
