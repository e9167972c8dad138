#include "server/physics/mechanics/contact/tissue_surface.h"

#include "common/assert.h"

namespace prosector::contact {
namespace {

SurfaceDetector detector(const Anatomy& anatomy) {
  return SurfaceDetector(anatomy.embedding, anatomy.surface, anatomy.thickness > 0);
}

bool is_simple(Fidelity fidelity) {
  return fidelity != Fidelity::none && fidelity != Fidelity::mesh;
}

}  // namespace

TissueSurface::TissueSurface(const Anatomy& anatomy) : anatomy_(&anatomy), vertices_(detector(anatomy)) {}

void TissueSurface::follow(const SurfaceEdit& edit, bool cut) {
  const bool was_cut = std::exchange(cut_, cut);
  vertices_.follow(edit);
  if (!was_cut || !cut) {
    faces_.reset();
    self_collision_.reset();
    return;
  }
  if (faces_) faces_->follow(edit, anatomy_->surface, vertices_.triangle_order());
  if (self_collision_) self_collision_->follow(edit, vertices_);
}

void TissueSurface::remake() {
  vertices_ = detector(*anatomy_);
  faces_.reset();
  self_collision_.reset();
}

void TissueSurface::fit(const SoftCollision& how, bool cut) {
  cut_ = cut;
  faces_moved_ = elements_moved_ = false;
  proxy_.reset();
  elements_.reset();
  thin_shell_ = false;
  if (is_simple(how.fidelity)) proxy_.emplace(*anatomy_, how.fidelity);
}

bool TissueSurface::fit_self_collision(double cell) {
  PROSECTOR_ASSERT(cell > 0 && !anatomy_->surface.triangles.empty());
  const bool closed = faces()->topology().closed();
  if (!closed)
    self_collision_.reset();
  else if (!self_collision_)
    self_collision_.emplace(*anatomy_, cell);
  return closed;
}

void TissueSurface::place(const VecX& x) {
  vertices_.update(x.data());
  if (proxy_) proxy_->fit(x, vertices_.positions());
}

const collision::TriangleSurface* TissueSurface::faces() {
  if (faces_ || anatomy_->surface.triangles.empty()) return faces_ ? &*faces_ : nullptr;
  if (cut_)
    faces_.emplace(anatomy_->surface, vertices_.triangle_order());
  else
    faces_.emplace(anatomy_->surface);
  return &*faces_;
}

const collision::TriangleSurface* TissueSurface::moved_faces() {
  const collision::TriangleSurface* own = faces();
  if (own && !faces_moved_) faces_->move(vertices_.positions());
  faces_moved_ = true;
  return own;
}

const ElementSurface& TissueSurface::elements(const VecX& x) {
  if (!elements_) elements_.emplace(*anatomy_);
  if (!elements_moved_) elements_->move(x);
  elements_moved_ = true;
  return *elements_;
}

}  // namespace prosector::contact
