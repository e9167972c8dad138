// Mutated files: each either loads or is refused with InputError; nothing else.

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "common/anatomy/surface_formats.h"
#include "common/anatomy/tet_io.h"
#include "common/anatomy/volume_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"
#include "tests/draft/surface_texts.h"

namespace prosector {
namespace {

using namespace testing_files;

void fuzz(const Bytes& seed, int rounds, std::size_t head, const std::function<void(const Bytes&)>& parse) {
  std::mt19937_64 random(20100611);
  int loaded = 0, refused = 0;
  for (int n = 0; n < rounds; ++n) {
    Bytes bytes = seed;
    const auto changes = random() % 6;
    for (std::uint64_t c = 0; c < changes; ++c) {
      const std::size_t at = random() % std::min(bytes.size(), random() % 4 == 0 ? bytes.size() : head);
      switch (random() % 4) {
        case 0:
          bytes[at] = static_cast<std::uint8_t>(random());
          break;
        case 1:
          bytes[at] ^= static_cast<std::uint8_t>(1u << (random() % 8));
          break;
        case 2:
          bytes[at] = static_cast<std::uint8_t>('0' + random() % 10);
          break;
        case 3:
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes[random() % bytes.size()]);
          break;
      }
    }
    if (random() % 8 == 0) bytes.resize(random() % bytes.size() + 1);
    try {
      parse(bytes);
      ++loaded;
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(loaded, rounds / 100);
  EXPECT_GT(refused, rounds / 100);
}

TEST(AnatomyFuzz, Inrimage) {
  fuzz(inrimage(4, 4, 4, {1, 1, 1}, std::vector<std::uint8_t>(64, 3)), 20000, 256,
       [](const Bytes& b) { parse_volume(b, "fuzz"); });
}

TEST(AnatomyFuzz, Nifti) {
  Bytes seed = nifti_header(4, 4, 4, 16);
  for (std::size_t n = 0; n < 64; ++n) put(seed, 352 + 4 * n, static_cast<float>(n));
  put<std::int16_t>(seed, 254, 1);
  for (std::size_t k = 0; k < 3; ++k) put(seed, 280 + 20 * k, 1.f);
  fuzz(seed, 20000, 352, [](const Bytes& b) { parse_volume(b, "fuzz"); });
}

TEST(AnatomyFuzz, SurfaceFiles) {
  const TriangleMesh box = box_surface(Vec3::Zero(), Vec3::Ones());
  std::string header = as_ply(box, 1);
  header = header.substr(0, header.find("end_header") + 11);
  header.replace(header.find("ascii"), 5, "binary_little_endian");
  Bytes binary(header.begin(), header.end());
  for (const Vec3& x : box.positions)
    for (int k = 0; k < 3; ++k) put(binary, binary.size(), static_cast<float>(x[k]));
  for (const auto& t : box.triangles) {
    put<std::uint8_t>(binary, binary.size(), 3);
    for (const std::uint32_t v : t) put(binary, binary.size(), v);
  }
  Bytes stl(80);
  put(stl, 80, static_cast<std::uint32_t>(box.triangles.size()));
  for (const auto& t : box.triangles) {
    stl.resize(stl.size() + 12);
    for (const std::uint32_t v : t)
      for (int k = 0; k < 3; ++k) put(stl, stl.size(), static_cast<float>(box.positions[v][k]));
    stl.resize(stl.size() + 2);
  }
  const std::string ply_text = as_ply(box, 1), stl_text = as_stl(box, 1);
  const auto parse_with = [](auto parse) {
    return [parse](const Bytes& b) {
      std::vector<std::string> notes;
      const TriangleMesh mesh =
          parse(std::string_view(reinterpret_cast<const char*>(b.data()), b.size()), notes);
      for (const auto& t : mesh.triangles)
        for (const std::uint32_t v : t) ASSERT_LT(v, mesh.positions.size());
    };
  };
  for (const Bytes& seed : {binary, Bytes(ply_text.begin(), ply_text.end())})
    fuzz(seed, 20000, seed.size(), parse_with(parse_ply));
  for (const Bytes& seed : {stl, Bytes(stl_text.begin(), stl_text.end())})
    fuzz(seed, 20000, seed.size(), parse_with(parse_stl));
}

TEST(AnatomyFuzz, TetFiles) {
  const std::string gmsh =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n"
      "$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n";
  const std::string vtk =
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 "
      "0 1\n"
      "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n";
  const auto text = [](const Bytes& b) {
    return std::string_view(reinterpret_cast<const char*>(b.data()), b.size());
  };
  fuzz(Bytes(gmsh.begin(), gmsh.end()), 20000, gmsh.size(),
       [&](const Bytes& b) { parse_gmsh(text(b), "fuzz"); });
  std::string binary =
      "# vtk DataFile Version 5.1\nt\nBINARY\nDATASET UNSTRUCTURED_GRID\nFIELD F 1\na 1 1 char\n\x01\n"
      "POINTS 4 float\n" +
      std::string(48, '\0') + "\nCELLS 2 4\nOFFSETS vtktypeint64\n" + std::string(15, '\0') +
      "\x04\nCONNECTIVITY vtktypeint32\n";
  for (const char point : {'\0', '\1', '\2', '\3'}) binary += std::string(3, '\0') + point;
  binary += "\nCELL_TYPES 1\n" + std::string(3, '\0') + "\x0a\n";
  for (const std::string& seed : {vtk, binary})
    fuzz(Bytes(seed.begin(), seed.end()), 20000, seed.size(),
         [&](const Bytes& b) { parse_vtk(text(b), "fuzz"); });
}

}  // namespace
}  // namespace prosector
