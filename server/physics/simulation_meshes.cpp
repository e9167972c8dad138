// What hangs on a soft body's mesh: made when the scene is compiled, and anew where a cut changes the mesh.

#include "server/physics/simulation_impl.h"

namespace prosector {

void Simulation::Impl::fit_to_mesh(std::size_t body) {
  const Anatomy& anatomy = model.soft[body]->anatomy();
  SurfaceDetector surface(anatomy.embedding, anatomy.surface);
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
    layers.emplace_back();
    folds.emplace_back();
    layers_moved.push_back(0);
    passed_through.push_back(0);
  } else {
    surfaces[body] = std::move(surface);
    faces_moved[body] = layers_moved[body] = 0;
    stored[body].reset();
  }
  faces[body].reset();
  if (!anatomy.surface.triangles.empty()) faces[body].emplace(anatomy.surface);
  fit_rough_shape(body);
  fit_layers(body);
  place_surface(body);
}

}  // namespace prosector
