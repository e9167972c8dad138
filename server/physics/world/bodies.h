#pragma once
// All bodies of a running simulation. Body ids count the rigid bodies first, in scene order, then the soft
// bodies.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/assert.h"
#include "server/physics/base/part.h"
#include "server/physics/world/model.h"
#include "server/physics/world/tissue.h"

namespace prosector {

struct Bodies {
  /// Creates the scene's bodies at their initial poses. `model`, the compiled scene, must outlive the object.
  Bodies(const Model& model, std::vector<CompiledTissue> tissues);

  const Model& model;
  rigid::RigidWorld rigid;              // includes hands, in slots after the bodies
  std::deque<Tissue> soft;              // a deque: addresses stay valid when pieces are added
  std::vector<Part> parts;              // by body
  std::map<BodyId, std::uint8_t> lost;  // number of times the body left the room since a hand last held it
  std::vector<std::unique_ptr<soft::SoftBody>> retired;  // replaced, but the tick's islands refer to them

  std::size_t count() const { return model.rigid.size() + soft.size(); }
  bool is_soft(BodyId body) const { return body >= model.rigid.size(); }
  std::size_t soft_index(BodyId body) const {
    PROSECTOR_ASSERT(is_soft(body));
    return body - model.rigid.size();
  }
  BodyId soft_id(std::size_t index) const { return static_cast<BodyId>(model.rigid.size() + index); }
  const std::string& name_of(BodyId body) const;
  /// Returns whether the scene declares the body as a part of the anatomy, which participants may detach and
  /// hide.
  bool is_part(BodyId body) const;
  /// Returns whether the soft bodies with indices a and b can collide. For a == b, returns whether the body
  /// can collide with itself.
  bool may_meet(std::size_t a, std::size_t b) const;
  /// Applies the changes that participants made to the body (its Part). For a rigid body, sets its presence
  /// in `world`: absent, fixed or free. For a soft body, sets its stiffness and attachment.
  void take_effect(rigid::RigidWorld& world, BodyId body);
  /// Wakes all sleeping bodies, except those that can't be touched because they are hidden or inspected.
  void wake_everything();
};

/// Returns each body's Part (the changes that participants make to it) at the start of the scene. Bone
/// fragments whose bone has not broken yet are hidden; no other body has changes.
std::vector<Part> initial_parts(const Model& model, std::size_t soft_bodies);
Part initial_part(const Model& model, BodyId body);

}  // namespace prosector
