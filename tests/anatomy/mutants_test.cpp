// Files of solids whose volume is known, written as people's programs get them wrong: each is filled about as
// it should be, or refused, or its author is told.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/error.h"
#include "tests/anatomy/files.h"
#include "tests/anatomy/reported_lines.h"
#include "tests/draft/surface_texts.h"
#include "tests/random.h"

namespace prosector {
namespace {

using namespace testing_files;

/// A file's content, and the volumes (ml) that it may be filled with.
struct Mutant {
  std::string name;  // of the file
  Bytes content;
  std::vector<double> truths;
  std::string story;
};

Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

double volume_of(const Box& box) {
  return box.size().prod();
}

double common_volume(const Box& a, const Box& b) {
  return (a.max.cwiseMin(b.max) - a.min.cwiseMax(b.min)).cwiseMax(0).prod();
}

Box random_box(Random& random, double least, double most) {
  const Vec3 low = random.point(50);
  return {low, low + Vec3::NullaryExpr([&] { return random.uniform(least, most); })};
}

/// Each triangle gets vertices of its own, some of them off by a rounding.
TriangleMesh as_soup(const TriangleMesh& mesh, Random& random) {
  TriangleMesh out;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      out.positions.push_back(mesh.positions[v]);
      if (random.below(4) == 0) out.positions.back() += random.point(5e-6);
    }
    const auto n = static_cast<std::uint32_t>(out.positions.size());
    out.triangles.push_back({n - 3, n - 2, n - 1});
  }
  return out;
}

void turn(TriangleMesh& mesh, std::size_t first, std::size_t end) {
  for (std::size_t t = first; t < end; ++t) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
}

/// A box, or two that lie in each other, cross or lie apart (mm).
Mutant surface_mutant(Random& random) {
  Mutant out;
  const Box a = random_box(random, 30, 80), b = random_box(random, 5, 80);
  TriangleMesh mesh = box_surface(a.min, a.max);
  out.truths = {volume_of(a)};
  if (random.below(4) > 0) {
    const double both = common_volume(a, b);
    TriangleMesh second = box_surface(b.min, b.max);
    const bool inward = random.below(2) == 0;
    if (inward) turn(second, 0, second.triangles.size());
    append(mesh, second);
    out.story += inward ? "second inward, " : "second outward, ";
    out.truths = {volume_of(a) + volume_of(b) - both};
    // One that faces inward is a cavity, or was written the wrong way round.
    if (inward) out.truths = {volume_of(a) - both, volume_of(b) - both, out.truths[0]};
    const bool within = both == volume_of(b) || both == volume_of(a);
    if (inward && within) out.truths = {std::max(volume_of(a), volume_of(b)) - both};
  }
  if (random.below(6) == 0) {
    turn(mesh, 0, mesh.triangles.size());
    out.story += "inside out, ";
  } else if (random.below(3) == 0) {
    const std::size_t at = random.below(mesh.triangles.size());
    turn(mesh, at, at + 1);
    out.story += "a triangle turned, ";
  }
  if (random.below(4) == 0) {
    mesh.triangles.push_back(mesh.triangles[random.below(mesh.triangles.size())]);
    out.story += "a triangle twice, ";
  }
  if (random.below(10) == 0) {
    mesh.triangles.pop_back();
    out.story += "open, ";
  }
  if (random.below(3) == 0) {
    mesh = as_soup(mesh, random);
    out.story += "soup, ";
  }
  const char* const names[] = {"m.off", "m.obj", "m.ply", "m.stl"};
  out.name = names[random.below(4)];
  out.content = bytes_of(as_text(out.name, mesh, 1));
  for (double& truth : out.truths) truth *= 1e-3;
  return out;
}

/// A row of cells (40 mm) as hexahedra, prisms and tetrahedra, some doubled, parted, inverted or tangled.
Mutant cells_mutant(Random& random) {
  Mutant out;
  out.name = "m.vtk";
  const std::size_t cells = 1 + random.below(4);
  out.truths = {64. * static_cast<double>(cells)};
  std::vector<Vec3> nodes;
  for (std::size_t i = 0; i <= cells; ++i)
    for (const auto& [y, z] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
      nodes.emplace_back(40 * static_cast<double>(i), 40 * y, 40 * z);
  std::vector<std::pair<int, std::vector<std::size_t>>> elements;
  for (std::size_t i = 0; i < cells; ++i) {
    const auto n = [&](std::size_t k) { return 4 * i + k; };
    switch (random.below(3)) {
      case 0:
        elements.push_back({12, {n(0), n(1), n(2), n(3), n(4), n(5), n(6), n(7)}});
        break;
      case 1:
        elements.push_back({13, {n(0), n(1), n(4), n(3), n(2), n(7)}});
        elements.push_back({13, {n(1), n(5), n(4), n(2), n(6), n(7)}});
        break;
      default:
        for (const auto& t : {std::array<std::size_t, 4>{0, 1, 2, 4},
                              {1, 5, 4, 2},
                              {4, 5, 6, 2},
                              {0, 2, 3, 4},
                              {3, 2, 7, 4},
                              {2, 6, 7, 4}})
          elements.push_back({10, {n(t[0]), n(t[1]), n(t[2]), n(t[3])}});
    }
  }
  if (random.below(4) == 0) {
    elements.push_back(elements[random.below(elements.size())]);
    out.story += "an element twice, ";
  }
  if (random.below(6) == 0) {
    elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(random.below(elements.size())));
    out.truths.clear();  // then it is what the rest is
    out.story += "one left out, ";
  }
  if (random.below(4) == 0) {
    nodes[random.below(nodes.size())] += random.point(60);
    out.truths.clear();
    out.story += "a node moved, ";
  }
  if (random.below(4) == 0) {
    std::vector<Vec3> own;
    for (auto& [type, corners] : elements)
      for (std::size_t& c : corners) {
        own.push_back(nodes[c]);
        c = own.size() - 1;
      }
    nodes = own;
    out.story += "nodes not merged, ";
  }
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", nodes.size());
  for (const Vec3& x : nodes) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  std::size_t numbers = 0;
  for (const auto& [type, corners] : elements) numbers += 1 + corners.size();
  text += fmt::format("CELLS {} {}\n", elements.size(), numbers);
  for (const auto& [type, corners] : elements) {
    text += fmt::format("{}", corners.size());
    for (const std::size_t c : corners) text += fmt::format(" {}", c);
    text += "\n";
  }
  text += fmt::format("CELL_TYPES {}\n", elements.size());
  for (const auto& [type, corners] : elements) text += fmt::format("{}\n", type);
  out.content = bytes_of(text);
  return out;
}

/// Boxes of label 1, whole, hollow, in pieces or thin, in a header that may say two things.
Mutant volume_mutant(Random& random) {
  Mutant out;
  out.name = "m.nii";
  constexpr int n = 24;
  std::vector<std::uint8_t> voxels(n * n * n);
  const auto put_box = [&](std::uint8_t label, int least, int most) {
    std::array<int, 3> low{}, size{};
    for (std::size_t k = 0; k < 3; ++k) {
      size[k] = least + static_cast<int>(random.below(static_cast<std::size_t>(most - least + 1)));
      low[k] = static_cast<int>(random.below(static_cast<std::size_t>(n - size[k] + 1)));
    }
    for (int z = 0; z < size[2]; ++z)
      for (int y = 0; y < size[1]; ++y)
        for (int x = 0; x < size[0]; ++x)
          voxels[static_cast<std::size_t>(low[0] + x + n * (low[1] + y + n * (low[2] + z)))] = label;
  };
  put_box(1, 8, 20);
  if (random.below(3) == 0) put_box(1, 1, 12);
  if (random.below(3) == 0) put_box(0, 1, 12);
  if (random.below(6) == 0) {
    std::ranges::fill(voxels, std::uint8_t{0});
    put_box(1, 1, 20);
  }
  const bool as_int64 = random.below(3) == 0;
  out.content = nifti_header(n, n, n, as_int64 ? 1024 : 2);
  const float mm = static_cast<float>(random.uniform(1, 3));
  for (std::size_t k = 0; k < 3; ++k) put(out.content, 80 + 4 * k, mm);
  double step = static_cast<double>(mm);
  if (random.below(3) == 0) {
    const float sform = mm * static_cast<float>(random.uniform(0.5, 2));
    put<std::int16_t>(out.content, 254, 1);
    for (std::size_t k = 0; k < 3; ++k) put(out.content, 280 + 20 * k, sform);
    step = static_cast<double>(sform);
    out.story += "sform, ";
  }
  if (random.below(3) == 0) put(out.content, 112, std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (as_int64)
      put<std::int64_t>(out.content, 352 + 8 * i, voxels[i]);
    else
      put(out.content, 352 + i, voxels[i]);
  }
  out.truths = {1e-3 * step * step * step * static_cast<double>(std::ranges::count(voxels, 1))};
  return out;
}

/// Changes some bytes of the file: then it holds something else, and only must not end the process.
void spoil(Mutant& mutant, Random& random) {
  for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
    const std::size_t at = random.below(mutant.content.size());
    if (random.below(3) == 0)
      mutant.content.erase(mutant.content.begin() + static_cast<std::ptrdiff_t>(at));
    else
      mutant.content[at] =
          static_cast<std::uint8_t>(random.below(2) == 0 ? '0' + random.below(10) : random.below(256));
  }
  mutant.truths.clear();
  mutant.story += "spoiled, ";
}

/// Makes the body. Returns its volume (ml); none: it was refused.
std::optional<double> made(const Mutant& mutant, Lines& said) {
  const TempDir dir;
  write(dir.path / mutant.name, mutant.content);
  SoftDesc desc;
  desc.name = "organ";
  const bool volume = mutant.name == "m.nii";
  (volume ? desc.geometry.volume : desc.geometry.mesh) = mutant.name;
  desc.geometry.label = 1;
  desc.geometry.smoothing = 0.7;
  desc.geometry.scale = 1e-3;
  desc.geometry.cell = volume ? 0.004 : 0.008;
  desc.geometry.surface_cell = 0.008;
  try {
    return 1e6 * tet_quality(make_anatomy(desc, {dir.path, {}, {}}, said.progress()).tets).volume;
  } catch (const InputError& error) {
    said.lines.push_back(error.what());
    return std::nullopt;
  }
}

void try_mutants(unsigned seed, std::size_t count) {
  Random random(seed);
  std::size_t taken = 0, refused = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Mutant mutant = i % 3 == 0   ? surface_mutant(random)
                    : i % 3 == 1 ? cells_mutant(random)
                                 : volume_mutant(random);
    if (random.below(5) == 0) spoil(mutant, random);
    Lines said;
    const std::optional<double> volume = made(mutant, said);
    (volume ? taken : refused)++;
    if (!volume || mutant.truths.empty()) continue;
    const bool right = std::ranges::any_of(
        mutant.truths, [&](double truth) { return std::abs(*volume / truth - 1) <= 0.2 + 1e-9; });
    std::string lines;
    for (const std::string& line : said.lines) lines += "\n  " + line;
    EXPECT_TRUE(right) << "mutant " << i << " of seed " << seed << ", " << mutant.name << " (" << mutant.story
                       << "): " << *volume << " ml, expected " << mutant.truths[0] << lines;
  }
  EXPECT_GT(taken, count / 4);
  EXPECT_GT(refused, count / 20);
}

TEST(FileMutants, OfAFixedSeed) {
  try_mutants(20261128, 60);
}

// The nightly run's: PROSECTOR_MUTANTS of them.
TEST(FileMutants, OfAnySeed) {
  try_mutants(test_seed(false), number("PROSECTOR_MUTANTS", 3000));
}

}  // namespace
}  // namespace prosector
