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

namespace prosector::soft {

/// Elements first … last − 1 of a body, which are processed together. Their integration points form the batch
/// with index `batch`.
struct ElementChunk {
  std::size_t batch, first, last;
  std::size_t size() const { return last - first; }
};

/// Operations on chunks (ranges) of a body's elements in which linear and quadratic tetrahedra differ.
/// Different chunks may be processed concurrently.
class ChunkedElements {
 public:
  virtual ~ChunkedElements() = default;

  /// Computes the deformation of the chunk's elements at node positions x (3n, m), for the functions below.
  virtual void place(const ElementChunk& chunk, const double* x) = 0;

  // ---- The chunk at the positions of the last place()
  /// Returns the strain energy, J, of the chunk's elements at the node positions of its last place().
  virtual double energy_of(const ElementChunk& chunk) const = 0;
  virtual void find_forces(const ElementChunk& chunk) = 0;
  /// Computes the stiffness blocks of the chunk's elements at the node positions of its last place(). If
  /// `warped`, this is the linear elastic stiffness rotated with each element, otherwise the projected
  /// tangent.
  virtual void find_stiffness(const ElementChunk& chunk, bool warped) = 0;
  /// Computes the chunk's rotated elements (data from which the corotational stiffness is assembled) into
  /// `out`. `share` is defined at ElasticModel::linearise().
  virtual void turn(const ElementChunk& chunk, double share, CorotatedElements& out) const = 0;

  // ---- All elements
  virtual std::span<const Vec3> forces() const = 0;     // N, by corner
  virtual std::span<const Mat3> stiffness() const = 0;  // N/m, by block
  /// Allocates memory for the stiffness blocks of all elements. Called before the first assembly that needs
  /// them; models with rotated elements seldom do.
  virtual void reserve_stiffness() = 0;
  virtual void reserve(CorotatedElements& out) const = 0;
};

/// Base class of finite-element models. It processes elements in chunks, in parallel, and caches energy and
/// forces at the last node positions, so that repeated calls for the same positions cost nothing.
class BatchedModel : public ElasticModel, protected ChunkedElements {
 public:
  const VecX& rest() const final { return rest_; }
  const Connectivity& connectivity() const final { return connectivity_; }
  bool objective() const final { return batches_->objective(); }
  double energy(const double* x) final;
  void add_gradient(const double* x, double* g) final;
  std::span<const Mat3> tangent(const double* x) final;
  std::span<const Mat3> warped_stiffness(const double* x) final;
  bool turns() const final { return batches_->turns() || batches_->has_point_tangents(); }
  void linearise(const double* x, double share, CorotatedElements& out) final;

  std::size_t history_size() const final { return relaxing_ ? relaxing_->history_size() : 0; }
  void begin_step(double h, const double* x, const double* history) final;
  void end_step(const double* x, double* history) final;
  void relax_fully() final;

 protected:
  /// Updates rest positions, connectivity and element batches after `edit` changed the mesh to `mesh`. The
  /// derived class must have updated its elements before.
  void follow_elements(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit);
  const Incidence& incidence() const { return incidence_; }

  BatchedModel(const TetMesh& mesh, Connectivity connectivity, std::unique_ptr<ElementBatches> batches,
               std::size_t elements_per_chunk);

  ElementBatches& batches() { return *batches_; }
  const ElementBatches& batches() const { return *batches_; }
  /// Returns the factor by which stress relaxation scales the law's instantaneous stress in the present step
  /// (c in relaxation.h); 1 without relaxation.
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

}  // namespace prosector::soft
