#pragma once
// Finds what soft bodies touch, and wakes what is touched by something awake.

#include <span>
#include <vector>

#include "server/physics/collision/broad/broad_phase.h"
#include "server/physics/contact/colliders.h"
#include "server/physics/contact/soft_contacts.h"
#include "server/physics/state.h"

namespace prosector {

class SoftContactFinder {
 public:
  explicit SoftContactFinder(std::size_t soft_bodies);

  /// Lists all contacts of soft bodies for a tick of h s. Waking spreads until nobody wakes any more: tissue
  /// wakes what rests on it, and the other way round. Of the state it changes who sleeps, which sides of thin
  /// shells are known, and who is led out of whom.
  const SoftContacts& find(State& state, std::span<const Collider> colliders, double h);
  const SoftContacts& found() const { return found_; }

  /// Appends where two soft bodies, or one with itself, come within `margin` (m). Returns whether there was
  /// any.
  bool add_pair_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                         std::vector<Contact>& out);

 private:
  void track(const Bodies& bodies, double h);
  void meet_rigid(State& state, std::span<const Collider> colliders, double h);
  void list_rigid(Bodies& bodies, Tissue& tissue, std::span<const Collider> colliders, double h);
  bool woken_by_soft(State& state, std::size_t body, double h);
  void meet_each_other(State& state, double h);
  bool add_thin_contacts(State& state, std::size_t a, std::size_t b, double margin, double h,
                         std::vector<Contact>& out);
  void lead_apart(State& state, Tissue& a, Tissue& b, double h, std::size_t first, std::vector<Contact>& out);
  void group(std::size_t soft_bodies);

  BroadPhase boxes_;         // of soft bodies that collide, by index
  std::size_t tracked_ = 0;  // soft bodies there were then
  SoftContacts found_;
  Entanglements still_entangled_;  // as found in this tick
  std::vector<VertexMeeting> meetings_;
  std::vector<std::vector<Contact>> by_collider_;  // of one body
};

}  // namespace prosector
