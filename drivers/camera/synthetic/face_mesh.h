#pragma once
// Faces before a synthetic camera: one of our own making, and the skin of the fetched CT's head.
//
// Their frame: the origin between the eyes, on the skin; the user's right is x, up is y, −z looks ahead; m.

#include <filesystem>

#include "drivers/camera/synthetic/mesh_layer.h"

namespace prosector {

struct FaceMesh {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Rgb> paint;
  double eye_distance = 0;  // m, between the pupils

  ShadedMesh painted() const { return {positions, normals, triangles, paint}; }
};

/// Makes a painted head with neck and shoulders: rough, but networks take it for a face.
FaceMesh make_face(double eye_distance);

/// Makes the skin of the CT's head. Its eyes are shut, and it ends at the upper lip. Takes seconds. Throws
/// InputError where the file isn't there; deploy/fetch_anatomy.sh fetches it.
FaceMesh load_ct_face(const std::filesystem::path& file);

}  // namespace prosector
