#include "server/accuracy/missing_functions.h"

#include <Eigen/LU>
#include <algorithm>

namespace prosector::estimation {

MissingFunctions::MissingFunctions(const EstimatedBody& body) : table(bubbles(body.quadratic)) {
  number(body);
  find_faces(body);
  make_compliance(body);
}

void MissingFunctions::number(const EstimatedBody& body) {
  for (std::size_t e = 0; e < body.element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      index.add(FunctionIndex::key(bubble.corners, body.elements.nodes(e)));
  index.close();
  owner.assign(size(), 0);
  for (std::size_t e = body.element_count(); e-- > 0;)
    for (const Bubble& bubble : table.of_tet) {
      const std::uint32_t k = index.find(FunctionIndex::key(bubble.corners, body.elements.nodes(e)));
      owner[k] = static_cast<std::uint32_t>(e);
    }
  for (std::size_t e = 0; e < body.element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      of_element.push_back(index.find(FunctionIndex::key(bubble.corners, body.elements.nodes(e))));
}

void MissingFunctions::find_faces(const EstimatedBody& body) {
  area.assign(body.vertex_count(), 0);
  for (OuterFace face : outer_faces(body.mesh)) {
    std::sort(face.begin(), face.end());
    std::array<std::uint32_t, 8> found{};
    bool all_there = true;  // false for faces of elements that were left out
    for (std::size_t k = 0; k < table.of_face.size(); ++k) {
      const auto key = FunctionIndex::key(table.of_face[k].corners, face);
      found[k] = index.find(key);
      all_there = all_there && found[k] < size() && index[found[k]] == key;
    }
    if (!all_there) continue;
    faces.push_back(face);
    of_face.insert(of_face.end(), found.begin(),
                   found.begin() + static_cast<std::ptrdiff_t>(table.of_face.size()));
    for (const std::uint32_t node : face) area[node] += area_vector(body.mesh, face).norm() / 3;
  }
}

void MissingFunctions::make_compliance(const EstimatedBody& body) {
  std::vector<Mat3> K(size(), Mat3::Zero());
  for (std::size_t e = 0; e < body.element_count(); ++e) {
    const MaterialLaws& law = body.laws[body.kind[e]];
    const Columns b = body.slopes(e);
    const double V = body.elements.volume(e);
    for (std::size_t k = 0; k < table.of_tet.size(); ++k) {
      const Bubble& bubble = table.of_tet[k];
      const Mat3 G = b * bubble.stiffness * b.transpose();
      const Vec3 mean = b * bubble.slope;
      const double least_tie = body.least_tie(e, bubble.corners);
      K[of_element[e * table.of_tet.size() + k]] +=
          V * (law.local.mu * (G.trace() * Mat3::Identity() + G) + law.local.lambda * G +
               law.mean * mean * mean.transpose() + least_tie * bubble.square * Mat3::Identity());
    }
  }
  for (const Mat3& stiffness : K) compliance.push_back(stiffness.inverse());
}

}  // namespace prosector::estimation
