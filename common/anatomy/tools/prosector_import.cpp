// prosector-import: reads one surface file for another program, so that a crash of the reader doesn't affect
// that program. Writes an ImportReply to standard output.

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
#include "common/anatomy/surface_formats.h"
#include "common/error.h"
#include "common/file_endings.h"
#include "common/regular_file.h"
#include "common/version.h"

namespace prosector {
namespace {

constexpr rlim_t max_cpu_seconds = 20;
constexpr rlim_t max_memory = rlim_t{2} << 30;
constexpr std::size_t max_file_bytes = std::size_t{1} << 30;
constexpr int max_node_depth = 1000;  // of the file's node tree, which `append` traverses recursively

void limit(int resource, rlim_t to) {
  const rlimit bound{to, to + 1};  // exceeding the hard limit kills the process without a message
  setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

/// Limits the resources of this process, and makes it end with its parent.
void set_limits() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CPU, max_cpu_seconds);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // the sanitizers reserve terabytes
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

/// Counts faces that aren't triangles: points and lines left by triangulation.
std::size_t other_faces(const aiScene& scene) {
  std::size_t out = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
      out += scene.mMeshes[m]->mFaces[f].mNumIndices == 3 ? 0 : 1;
  return out;
}

/// Reads a format that has a built-in reader.
ImportReply read_with_builtin_reader(const char* file,
                                     TriangleMesh (*parse)(std::string_view, std::vector<std::string>&)) {
  ImportReply reply;
  const std::string bytes = read_regular_file(file, max_file_bytes);
  reply.mesh = parse(bytes, reply.notes);
  return reply;
}

ImportReply read_surface(const char* file) {
  ImportReply reply;
  try {
    if (has_ending(file, ".ply")) return read_with_builtin_reader(file, parse_ply);
    if (has_ending(file, ".stl")) return read_with_builtin_reader(file, parse_stl);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr)
      return {{}, fmt::format("its reader reports: {}", importer.GetErrorString())};
    append(*scene, *scene->mRootNode, aiMatrix4x4(), 0, reply.mesh);
    if (const std::size_t other = other_faces(*scene); other > 0)
      reply.notes.push_back(fmt::format("{} points and lines of the file are not used", other));
  } catch (const std::bad_alloc&) {
    return {{},
            fmt::format("reading this surface file needs more than {} GB of memory, which is the limit",
                        max_memory >> 30)};
  } catch (const InputError& error) {
    return {{}, error.what()};
  } catch (const std::exception& error) {
    return {{}, fmt::format("its reader reports: {}", error.what())};
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
