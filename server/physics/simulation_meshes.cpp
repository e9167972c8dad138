// What hangs on a soft body's mesh: made when the scene is compiled, and taken along or made anew where a cut
// changes the mesh.
// The tree of its faces, which few ask for, when it is asked for: from the rest shape, so it doesn't matter
// when.

#include "server/physics/simulation_impl.h"

namespace prosector {

SurfaceDetector Simulation::Impl::detector(const SoftBody& body) {
  return SurfaceDetector(body.anatomy().embedding, body.anatomy().surface, body.anatomy().thickness > 0);
}

void Simulation::Impl::fit_to_mesh(std::size_t body, SurfaceDetector surface, Numbering numbering) {
  if (body == surfaces.size()) {
    surfaces.push_back(std::move(surface));
    faces.emplace_back();
    faces_moved.push_back(0);
    soft_contacts.emplace_back();
    memories.emplace_back();
    revisions.push_back(0);
    numberings.emplace_back();
    rough.emplace_back();
    stored.emplace_back();
    layered.push_back(0);
    layers.emplace_back();
    folds.emplace_back();
    layers_moved.push_back(0);
    passed_through.push_back(0);
    inside_out.emplace_back();
    parted.emplace_back();
  } else {
    surfaces[body] = std::move(surface);
  }
  faces[body].reset();
  folds[body].reset();
  fit_rest_to_mesh(body, std::move(numbering));
}

void Simulation::Impl::fit_rest_to_mesh(std::size_t body, Numbering numbering) {
  numberings[body] = std::move(numbering);
  faces_moved[body] = layers_moved[body] = 0;
  stored[body].reset();
  fit_rough_shape(body);
  fit_layers(body);
  place_surface(body);
}

void Simulation::Impl::follow_nodes(std::size_t body) {
  place_surface(body);
  faces_moved[body] = layers_moved[body] = 0;
  inside_out[body].known = false;
}

const TriangleSurface* Simulation::Impl::faces_of(std::size_t body) {
  std::optional<TriangleSurface>& own = faces[body];
  const TriangleMesh& surface = model.soft[body]->anatomy().surface;
  if (own || surface.triangles.empty()) return own ? &*own : nullptr;
  if (numberings[body].triangles.empty())
    own.emplace(surface);
  else  // it was cut: the tree of an order can follow
    own.emplace(surface, surfaces[body].triangle_order());
  return &*own;
}

}  // namespace prosector
