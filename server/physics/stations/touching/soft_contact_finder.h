#pragma once
// Finds contacts of soft bodies, and wakes sleeping bodies that awake ones touch.

#include <span>
#include <vector>

#include "server/physics/mechanics/collision/broad/broad_phase.h"
#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Finder of the contacts of all soft bodies in a tick, with rigid bodies and with each other.
class SoftContactFinder {
 public:
  explicit SoftContactFinder(std::size_t soft_bodies);

  /// Finds all contacts of soft bodies for a tick of h s. Wakes sleeping bodies that awake ones touch,
  /// repeatedly until no further body wakes: tissue wakes bodies that rest on it, and vice versa. Changes
  /// these parts of the state: sleep states, known sides of thin shells, and entanglements.
  const contact::SoftContacts& find(State& state, std::span<const contact::Collider> colliders, double h);
  const contact::SoftContacts& found() const { return found_; }

  /// Appends contacts of the soft bodies a and b (indices), or of one with itself if a == b, within `margin`
  /// (m) to `out`, for a tick of h s. Returns whether there was any.
  bool add_pair_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                         std::vector<contact::Contact>& out);

 private:
  void track(const Bodies& bodies, double h);
  void meet_rigid(State& state, std::span<const contact::Collider> colliders, double h);
  void list_rigid(Bodies& bodies, Tissue& tissue, std::span<const contact::Collider> colliders, double h);
  bool woken_by_soft(State& state, std::size_t body, double h);
  void meet_each_other(State& state, double h);
  bool add_thin_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                         std::vector<contact::Contact>& out);
  void lead_apart(State& state, Tissue& a, Tissue& b, double h, std::size_t first,
                  std::vector<contact::Contact>& out);
  void group(std::size_t soft_bodies);

  collision::BroadPhase boxes_;  // of soft bodies that collide, by index
  std::size_t tracked_ = 0;      // number of soft bodies at the last update
  contact::SoftContacts found_;
  Entanglements still_entangled_;  // found in this tick
  std::vector<contact::VertexMeeting> meetings_;
  std::vector<std::vector<contact::Contact>> by_collider_;  // of one body
};

}  // namespace prosector
