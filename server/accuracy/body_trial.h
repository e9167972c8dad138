#pragma once
// Trials of models and elements on the body itself: the displacements at rest in each act are compared with a
// reference.
//
// The reference is tissue's law in quadratic elements on the body's own mesh, with every tetrahedron divided
// into eight. On large meshes it is undivided, and then judges linear elements only. So the errors are those
// of the mechanics. Differences between the mesh and the imaged shape are not included.
//
// The undivided reference shows how far the divided one is from convergence. That is a third of their
// difference, since displacements converge at second order at least. Where a body's law turns it inside out,
// or the body doesn't settle, the error is `collapsed`.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/accuracy/act.h"
#include "server/accuracy/displacement.h"
#include "server/accuracy/foot.h"

namespace prosector {

/// Value of a relative error that stands for a trial body that turned inside out or does not come to rest. No
/// relative error of displacements is that large.
inline constexpr double collapsed = 1e3;

struct ActError {
  std::string act;
  double error = 0;  // relative error of displacements; at least `collapsed`: it collapsed, or didn't settle
  double unsettled = 0;  // share of `error` that is the reference's own
};

/// Returns the act (test load) with the largest error; `acts` must not be empty.
const ActError& worst(const std::vector<ActError>& acts);

/// Name of the constitutive law that real tissue is assumed to follow where a scene's author names none.
inline constexpr const char* tissue_law = "fem_neo_hookean";

struct TrialSettings {
  std::string law = tissue_law;  // law of the reference
  std::size_t most_tets = 6000;  // limit of tetrahedra of the reference
  int presses = 6;               // places that a fingertip presses
  bool tilts = true;             // whether a free body is tilted, too
  double weight = 1;             // factor on the body's weight
  /// Function that is called before each step of the solver. It may throw an exception to abort the trial.
  /// Empty: not called.
  std::function<void()> before_step = {};
};

class BodyTrial {
 public:
  /// Computes the reference displacements of the body under each test load on `mesh`, in the world frame. The
  /// anatomy's surface is not used.
  BodyTrial(const SoftDesc& desc, const Vec3& gravity, Anatomy mesh, const TrialSettings& settings);
  ~BodyTrial();
  BodyTrial(BodyTrial&&) noexcept;

  /// Returns whether the reference mesh was divided, so that quadratic elements can be judged by it, too. An
  /// undivided reference judges linear elements only.
  bool judges_quadratic() const { return divided_; }
  /// Returns the relative displacement errors of that model and element on the body, one for each act (test
  /// load). The reference's own error is included. Throws std::logic_error for quadratic elements if
  /// judges_quadratic() is false.
  std::vector<ActError> measure(const std::string& model, const std::string& element) const;
  const std::vector<Act>& acts() const { return acts_; }

 private:
  struct Solved;
  void leave_out_unborne();
  std::unique_ptr<Solved> solve(const std::string& model, const std::string& element,
                                const Anatomy& mesh) const;
  double difference(std::size_t act, const Solved& one, const Solved& other) const;

  SoftDesc desc_;
  Anatomy mesh_;
  bool divided_;
  std::vector<std::optional<Foot>> feet_;  // by act
  std::vector<Act> acts_;
  std::function<void()> before_step_;
  std::vector<Vec3> places_;
  std::unique_ptr<Solved> reference_;
  std::vector<double> unsettled_;  // by act
};

}  // namespace prosector
