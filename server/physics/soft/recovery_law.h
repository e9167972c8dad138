#pragma once
// The law under which a soft body is stepped where its own leaves it inside out.

#include <memory>

#include "server/physics/soft/soft_matter.h"

namespace prosector {

class SoftBody;

/// Makes, when first asked for, a body of the same nodes and attachments under the corotational law. That law
/// leads out of every shape: no minimum but the rest shape was ever seen.
class RecoveryLaw {
 public:
  /// Takes the body's matter, which must outlive this.
  explicit RecoveryLaw(const SoftMatter& matter);
  ~RecoveryLaw();

  /// Tells whether there is one: not for bodies under that law on linear tetrahedra, nor for sheets and
  /// ropes.
  bool exists() const;
  /// Returns the body under it, on linear tetrahedra (eight for each quadratic one). Asks for exists().
  SoftBody& body();
  /// Keeps it in force for good: under its own law the body's own weight crushes it. Asks for exists().
  void keep() { kept_ = true; }
  bool is_kept() const { return kept_; }

  // ---- When the matter changes, between steps
  /// Takes in its strength and whether it is tied.
  void reweigh();
  /// Takes in that it followed a cut.
  void fit();

 private:
  const SoftMatter& matter_;
  std::unique_ptr<SoftBody> body_;
  bool kept_ = false;
};

}  // namespace prosector
