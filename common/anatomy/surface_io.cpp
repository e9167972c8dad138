#include "common/anatomy/surface_io.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <map>

#include "common/anatomy/simplify.h"
#include "common/error.h"

namespace prosector {
namespace {

void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, TriangleMesh& out) {
  const aiMatrix4x4 transform = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const auto base = static_cast<std::uint32_t>(out.positions.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D x = transform * mesh.mVertices[v];
      out.positions.emplace_back(static_cast<double>(x.x), static_cast<double>(x.y),
                                 static_cast<double>(x.z));
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices == 3)
        out.triangles.push_back({base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]});
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c) append(scene, *node.mChildren[c], transform, out);
}

// Readers give each triangle its own vertices where normals or seams differ: here a place is a vertex.
void merge_equal(TriangleMesh& mesh) {
  std::map<std::array<double, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> number(mesh.positions.size());
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    const Vec3& x = mesh.positions[v];
    number[v] = first.try_emplace({x[0], x[1], x[2]}, v).first->second;
  }
  for (auto& t : mesh.triangles)
    for (auto& v : t) v = number[v];
  drop_unused(mesh);
}

}  // namespace

TriangleMesh load_surface(const std::filesystem::path& file, double scale) {
  const std::string name = file.string();
  if (!std::filesystem::is_regular_file(file)) throw InputError(fmt::format("{}: no such file", name));
  if (!(scale > 0) || !std::isfinite(scale))
    throw InputError(fmt::format("{}: scale {}; allowed: above 0", name, scale));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(name, aiProcess_Triangulate | aiProcess_ValidateDataStructure);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw InputError(fmt::format("{}: not a surface ({}); allowed: OBJ, STL, PLY, OFF, glTF", name,
                                 importer.GetErrorString()));
  TriangleMesh mesh;
  append(*scene, *scene->mRootNode, aiMatrix4x4(), mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (!mesh.positions[v].allFinite())
      throw InputError(fmt::format("{}: vertex {} is not a finite position", name, v));
    mesh.positions[v] *= scale;
  }
  merge_equal(mesh);
  if (mesh.triangles.empty()) throw InputError(fmt::format("{}: no triangles; allowed: at least one", name));
  Vec3 low = mesh.positions.front(), high = low;
  for (const Vec3& x : mesh.positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double extent = (high - low).maxCoeff();
  constexpr double max_extent = 100, min_extent = 1e-4;
  if (!(extent >= min_extent && extent <= max_extent))
    throw InputError(fmt::format(
        "{}: {} m across at scale {}; allowed: {} to {} m (is the file in millimetres? scale = 0.001)", name,
        extent, scale, min_extent, max_extent));
  return mesh;
}

}  // namespace prosector
