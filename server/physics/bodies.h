#pragma once
// All bodies of a running simulation. Ids count the rigid ones first, in scene order, then the soft ones.

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/assert.h"
#include "server/physics/model.h"
#include "server/physics/part.h"
#include "server/physics/tissue.h"

namespace prosector {

struct Bodies {
  /// Puts the scene's bodies where it says. `model` outlives this.
  Bodies(const Model& model, std::vector<CompiledTissue> tissues);

  const Model& model;
  RigidWorld rigid;                     // hands, too, in slots behind the bodies
  std::deque<Tissue> soft;              // addresses stay as pieces come
  std::vector<Part> parts;              // by body
  std::map<BodyId, std::uint8_t> lost;  // how often they left the room since somebody last held them
  std::vector<std::unique_ptr<SoftBody>> retired;  // replaced, but the tick's islands still know them

  std::size_t count() const { return model.rigid.size() + soft.size(); }
  bool is_soft(BodyId body) const { return body >= model.rigid.size(); }
  std::size_t soft_index(BodyId body) const {
    PROSECTOR_ASSERT(is_soft(body));
    return body - model.rigid.size();
  }
  BodyId soft_id(std::size_t index) const { return static_cast<BodyId>(model.rigid.size() + index); }
  const std::string& name_of(BodyId body) const;
  /// Returns whether the body is a part of the anatomy, which people may take out and hide.
  bool is_part(BodyId body) const;
  /// Returns whether two soft bodies touch at all, or one touches itself.
  bool may_meet(std::size_t a, std::size_t b) const;
  /// Makes the body take part in `world` as its Part says; makes a soft one as stiff and as attached.
  void take_effect(RigidWorld& world, BodyId body);
  /// Wakes all that can be touched.
  void wake_everything();
};

/// Returns what was made of each body when the scene begins: pieces of bones are hidden.
std::vector<Part> initial_parts(const Model& model, std::size_t soft_bodies);
Part initial_part(const Model& model, BodyId body);

}  // namespace prosector
