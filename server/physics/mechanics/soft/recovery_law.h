#pragma once
// Material law used to recover a soft body that its own law leaves inverted.

#include <memory>

#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector::soft {

class SoftBody;

/// Copy of a soft body, with the same nodes and attachments, whose material is corotational. It replaces the
/// body while the body's own law leaves it inverted. Under the corotational law no energy minimum except the
/// rest shape was ever observed. The copy is created when first needed.
class RecoveryLaw {
 public:
  /// Stores a reference to the mesh, elements and masses of the body to recover, which must outlive this
  /// object.
  explicit RecoveryLaw(const SoftMatter& matter);
  ~RecoveryLaw();

  /// Returns whether the body can be stepped under a recovery law. False for sheets and ropes, and for bodies
  /// of linear tetrahedra that use the corotational law already.
  bool exists() const;
  /// Returns the copy of the body with the corotational material, creating it at the first call. It has
  /// linear tetrahedra, eight for each quadratic one. Requires that such a copy is possible: exists().
  SoftBody& body();
  /// Makes the body use the recovery law permanently, because its weight would crush it under its own
  /// material law. Requires exists().
  void keep() { kept_ = true; }
  bool is_kept() const { return kept_; }

  // ---- When the matter changes, between steps
  /// Applies the original body's stiffness factor, and whether its attachments hold, to the copy after they
  /// changed.
  void reweigh();
  /// Discards the copy of the body after a cut changed the original's mesh; body() creates it again when
  /// needed.
  void fit();

 private:
  const SoftMatter& matter_;
  std::unique_ptr<SoftBody> body_;
  bool kept_ = false;
};

}  // namespace prosector::soft
