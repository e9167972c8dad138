#pragma once
// Common base of finite-element models, independent of the element type. The elements are divided into
// chunks, and the integration points of a chunk form a batch. The model caches the data at the last
// positions, and handles stress relaxation.

#include <memory>
#include <span>
#include <vector>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/elements/relaxation.h"

namespace prosector {

/// Elements [first, last), whose integration points are batch number `batch`.
struct ElementChunk {
  std::size_t batch, first, last;
  std::size_t size() const { return last - first; }
};

/// Operations in which element types differ. Different chunks may be processed concurrently.
class ChunkedElements {
 public:
  virtual ~ChunkedElements() = default;

  /// Moves the chunk's elements to positions x, 3n, m.
  virtual void place(const ElementChunk& chunk, const double* x) = 0;

  // ---- The chunk at the positions of the last place()
  /// Returns the energy of the chunk, J.
  virtual double energy_of(const ElementChunk& chunk) const = 0;
  virtual void find_forces(const ElementChunk& chunk) = 0;
  /// Computes the tangent or the warped stiffness.
  virtual void find_stiffness(const ElementChunk& chunk, bool warped) = 0;
  /// Writes the chunk's rotated elements, see ElasticModel::linearise().
  virtual void turn(const ElementChunk& chunk, double share, CorotatedElements& out) const = 0;

  // ---- All elements
  virtual std::span<const Vec3> forces() const = 0;     // N, by corner
  virtual std::span<const Mat3> stiffness() const = 0;  // N/m, by block
  /// Allocates the stiffness when first needed; models with rotated elements seldom need it.
  virtual void reserve_stiffness() = 0;
  virtual void reserve(CorotatedElements& out) const = 0;
};

/// Caches the positions of the elements and the results there, and processes the elements in chunks.
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
  void linearise(const double* x, double share, CorotatedElements& out) final;

  std::size_t history_size() const final { return relaxing_ ? relaxing_->history_size() : 0; }
  void begin_step(double h, const double* x, const double* history) final;
  void end_step(const double* x, double* history) final;
  void relax_fully() final;

 protected:
  /// Updates the data shared by all element types after an edit. The derived class must have updated the
  /// elements before.
  void follow_elements(const SoftDesc& desc, const TetMesh& mesh, const MeshEdit& edit);
  const Incidence& incidence() const { return incidence_; }

  BatchedModel(const TetMesh& mesh, Connectivity connectivity, std::unique_ptr<ElementBatches> batches,
               std::size_t elements_per_chunk);

  ElementBatches& batches() { return *batches_; }
  const ElementBatches& batches() const { return *batches_; }
  /// Returns the factor by which a step scales the law's instantaneous stress, see relaxation.h.
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
  RelaxingBatches* relaxing_;  // batches_ if the body has stress relaxation, else null
  std::size_t elements_per_chunk_;
  std::vector<double> sums_;  // J, one per chunk
  VecX moved_to_;             // 3n: positions at which `batches_` are
  bool moved_ = false, energy_known_ = false, forces_known_ = false;
};

}  // namespace prosector
