#pragma once
// Soft bodies of a simulation, as input of the topology log.

#include "server/physics/mechanics/soft/soft_body.h"
#include "server/session/sending/topology_log.h"

namespace prosector {

class SimulatedShapes final : public SoftShapes {
 public:
  explicit SimulatedShapes(const Simulation& simulation) : simulation_(simulation) {}
  Shape shape(BodyId body) const override {
    return {simulation_.soft(body).anatomy(), simulation_.numbering(body),
            simulation_.soft_state(body).motion.x};
  }
  SceneBody describe(BodyId body, const SurfaceLog& surface) const override {
    return describe_soft(simulation_, body, surface);
  }

 private:
  const Simulation& simulation_;
};

}  // namespace prosector
