#pragma once
// Material law used to recover a soft body that its own law leaves inverted.

#include <memory>

#include "server/physics/mechanics/soft/soft_matter.h"

namespace prosector {

class SoftBody;

/// Body with the same nodes and attachments under the corotational law, created when first needed. The
/// corotational law leads back from every shape: no minimum except the rest shape was ever observed.
class RecoveryLaw {
 public:
  /// Takes the body's matter, which must outlive this object.
  explicit RecoveryLaw(const SoftMatter& matter);
  ~RecoveryLaw();

  /// Returns whether the body has a recovery law. Bodies of linear tetrahedra under the corotational law,
  /// sheets and ropes have none.
  bool exists() const;
  /// Returns the body under the recovery law, on linear tetrahedra (eight for each quadratic one). Requires
  /// exists().
  SoftBody& body();
  /// Uses the recovery law permanently, because the body's weight crushes it under its own law. Requires
  /// exists().
  void keep() { kept_ = true; }
  bool is_kept() const { return kept_; }

  // ---- When the matter changes, between steps
  /// Updates strength and attachment after they changed.
  void reweigh();
  /// Updates the body after its matter followed a cut.
  void fit();

 private:
  const SoftMatter& matter_;
  std::unique_ptr<SoftBody> body_;
  bool kept_ = false;
};

}  // namespace prosector
