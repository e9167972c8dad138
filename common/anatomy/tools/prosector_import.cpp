// prosector-import: reads one surface file for another program, which a crash of the reader then can't take
// along. Writes an ImportReply to standard output.

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <assimp/Importer.hpp>
#include <csignal>
#include <cstdio>
#include <new>
#include <string_view>

#include "common/anatomy/import_reply.h"
#include "common/version.h"

namespace prosector {
namespace {

constexpr rlim_t max_cpu_seconds = 20;
constexpr rlim_t max_memory = rlim_t{2} << 30;
constexpr int max_node_depth = 1000;  // of the file's own tree of nodes, which `append` walks down

void limit(int resource, rlim_t to) {
  const rlimit bound{to, to + 1};  // the second ends the process without a word
  setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

/// Limits what this process may use, and lets it end with the one that started it.
void set_limits() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CPU, max_cpu_seconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // these reserve terabytes
  limit(RLIMIT_AS, max_memory);
#endif
}

void append(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, int depth,
            TriangleMesh& out) {
  if (depth > max_node_depth) return;
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
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    append(scene, *node.mChildren[c], transform, depth + 1, out);
}

ImportReply read_surface(const char* file) {
  ImportReply reply;
  try {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr)
      return {{}, fmt::format("its reader says: {}", importer.GetErrorString())};
    append(*scene, *scene->mRootNode, aiMatrix4x4(), 0, reply.mesh);
  } catch (const std::bad_alloc&) {
    return {{}, fmt::format("its reader needs more than {} GB of memory", max_memory >> 30)};
  } catch (const std::exception& error) {
    return {{}, fmt::format("its reader says: {}", error.what())};
  }
  return reply;
}

bool write_all(const std::vector<std::uint8_t>& bytes) {
  return std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() && std::fflush(stdout) == 0;
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) {
  if (argc == 2 && std::string_view(argv[1]) == "--version") {
    fmt::print("{}\n", prosector::version_line("prosector-import"));
    return 0;
  }
  if (argc != 2 || argv[1][0] == '-' || isatty(STDOUT_FILENO) != 0) {
    fmt::print(stderr, "prosector-import FILE: reads a surface file for Prosector's other programs\n");
    return 2;
  }
  prosector::set_limits();
  return prosector::write_all(prosector::encode(prosector::read_surface(argv[1]))) ? 0 : 1;
}
