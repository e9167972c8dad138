#pragma once
// Face meshes for a synthetic camera: a modelled face, and the skin of the fetched CT's head.
//
// Frame: the origin is between the eyes, on the skin; x to the user's right, y up, −z forward; m.

#include <filesystem>

#include "twins/camera/mesh_layer.h"

namespace prosector {

struct FaceMesh {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Rgb> paint;
  double eye_distance = 0;  // m, between the pupils

  ShadedMesh painted() const { return {positions, normals, triangles, paint}; }
};

/// Builds a painted mesh of a head with neck and shoulders. `eye_distance` is the distance between the
/// pupils, m. The head is rough, but networks detect it as a face.
FaceMesh make_face(double eye_distance);

/// Extracts the skin of a head as a mesh from a CT data set. Its eyes are shut, and it ends at the upper lip.
/// Takes seconds. Throws InputError if the file is missing; deploy/fetch_anatomy.sh downloads it.
FaceMesh load_ct_face(const std::filesystem::path& file);

}  // namespace prosector
