#pragma once
// What finite-element models have in common, whatever their elements. These lie in chunks, whose integration
// points are a batch. The model keeps what is known of the place that they are at, and lets stress relax.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/parallel.h"
#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/elements/relaxation.h"

namespace prosector {

/// Elements [first, last), whose points are batch number `batch`.
struct ElementChunk {
  std::size_t batch, first, last;
  std::size_t size() const { return last - first; }
};

/// What models on batches differ in: their elements. Several chunks may be worked on at once.
class ChunkedElements {
 public:
  virtual ~ChunkedElements() = default;

  /// Puts the chunk at x, 3n, m.
  virtual void place(const ElementChunk& chunk, const double* x) = 0;

  // ---- The chunk where it was placed
  /// Returns its energy, J.
  virtual double energy_of(const ElementChunk& chunk) const = 0;
  virtual void find_forces(const ElementChunk& chunk) = 0;
  /// Finds the tangent, or the warped stiffness.
  virtual void find_stiffness(const ElementChunk& chunk, bool warped) = 0;
  /// Writes the chunk's turned elements, see ElasticModel::linearise().
  virtual void turn(const ElementChunk& chunk, double share, TurnedElements& out) const = 0;

  // ---- All elements
  virtual std::span<const Vec3> forces() const = 0;     // N, by corner
  virtual std::span<const Mat3> stiffness() const = 0;  // N/m, by block
  /// Makes room for the stiffness when first asked for: models that turn seldom are.
  virtual void reserve_stiffness() = 0;
  virtual void reserve(TurnedElements& out) const = 0;
};

/// Knows where the elements are and what was found there, and goes through them in chunks.
class BatchedModel : public ElasticModel, protected ChunkedElements {
 public:
  const VecX& rest() const final { return rest_; }
  const Connectivity& connectivity() const final { return connectivity_; }
  bool objective() const final { return batches_->objective(); }
  double energy(const double* x) final;
  void add_gradient(const double* x, double* g) final;
  std::span<const Mat3> tangent(const double* x) final;
  std::span<const Mat3> warped_stiffness(const double* x) final;
  bool turns() const final { return batches_->turns(); }
  void linearise(const double* x, double share, TurnedElements& out) final;

  std::size_t history_size() const final { return relaxing_ ? relaxing_->history_size() : 0; }
  void begin_step(double h, const double* x, const double* history) final;
  void end_step(const double* x, double* history) final;
  void relax_fully() final;

 protected:
  /// Takes along what the elements share; the derived class has taken the elements along already.
  void follow_elements(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit);
  const Incidence& incidence() const { return incidence_; }

  BatchedModel(const TetMesh& mesh, Connectivity connectivity, std::unique_ptr<ElementBatches> batches,
               std::size_t elements_per_chunk);

  ElementBatches& batches() { return *batches_; }
  const ElementBatches& batches() const { return *batches_; }
  /// Returns the share that a step stores of what the law would at once, see relaxation.h.
  double instant_share() const { return relaxing_ ? relaxing_->instant_share() : 1; }

 private:
  bool take(const double* x);
  void move(const double* x);
  template <class F>
  void for_chunks(const F& f) const {
    parallel_chunks(connectivity_.size(), elements_per_chunk_,
                    [&](std::size_t first, std::size_t last, std::size_t batch) {
                      f(ElementChunk{batch, first, last});
                    });
  }

  VecX rest_;
  Connectivity connectivity_;
  Incidence incidence_;
  std::unique_ptr<ElementBatches> batches_;
  RelaxingBatches* relaxing_;  // batches_ where stress relaxes
  std::size_t elements_per_chunk_;
  std::vector<double> sums_;  // J, one a chunk
  VecX moved_to_;             // 3n: where `batches_` are
  bool moved_ = false, energy_known_ = false, forces_known_ = false;
};

}  // namespace prosector
