// docs/look-up/scenes.md lists every shipped scene with what can be done in it, as the scene files have it.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>
#include <sstream>

#include "common/scene/load_scene.h"
#include "tests/folders.h"

namespace prosector {
namespace {

using Path = std::filesystem::path;
const Path root = source_path(".");
constexpr std::size_t most_names = 6;  // in a cell of the table

std::string text_of(const Path& file) {
  std::ifstream in(file);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<Path> shipped_scenes() {
  std::vector<Path> out;
  for (const auto& entry : std::filesystem::directory_iterator(root / "deploy/scenes"))
    if (entry.path().extension() == ".toml") out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

std::string cell(const std::vector<std::string>& names) {
  if (names.empty()) return "none";
  if (names.size() > most_names) return fmt::format("{} bodies", names.size());
  return fmt::format("{}", fmt::join(names, ", "));
}

template <class Desc>
void add_names(const std::vector<Desc>& bodies, const std::function<bool(const Desc&)>& counts,
               std::vector<std::string>& out) {
  for (const Desc& body : bodies)
    if (counts(body)) out.push_back(body.name);
}

/// Returns the row that the page must have of a scene.
std::string row_of(const Path& file) {
  const SceneDesc scene = load_scene(file);
  std::vector<std::string> parts, pulled, lifted, blades;
  for (std::size_t k = 0; k < scene.atlases.size(); ++k) parts.push_back("each region of its label map");
  add_names<SoftDesc>(
      scene.soft, [](const SoftDesc& s) { return s.part; }, parts);
  add_names<RigidDesc>(
      scene.rigid, [](const RigidDesc& r) { return r.part; }, parts);
  add_names<SoftDesc>(
      scene.soft, [](const SoftDesc& s) { return !s.part; }, pulled);
  add_names<RigidDesc>(
      scene.rigid, [](const RigidDesc& r) { return !r.fixed && !r.part; }, lifted);
  add_names<RigidDesc>(
      scene.rigid, [](const RigidDesc& r) { return !r.fixed && !r.edges.empty(); }, blades);
  return fmt::format("| [{}](../../deploy/scenes/{}) | {} | {} | {} | {} | {} |", file.stem().string(),
                     file.filename().string(), scene.description, cell(parts), cell(pulled), cell(lifted),
                     cell(blades));
}

TEST(ShippedScenes, AreListedWithWhatCanBeDoneInThem) {
  const std::string page = text_of(root / "docs/look-up/scenes.md");
  for (const Path& file : shipped_scenes())
    EXPECT_NE(page.find(row_of(file)), std::string::npos) << "docs/look-up/scenes.md lacks this row:\n"
                                                          << row_of(file);
}

// Organs of a shipped scene have a panel and can be taken out: lessons say so of every organ.
TEST(ShippedScenes, HaveTheirOrgansAsPartsOfTheAnatomy) {
  const std::set<std::string> organs = {"liver", "kidney", "gallbladder", "brain"};
  for (const Path& file : shipped_scenes())
    for (const SoftDesc& body : load_scene(file).soft)
      EXPECT_EQ(body.part, organs.contains(body.name)) << file.filename() << ": " << body.name;
}

}  // namespace
}  // namespace prosector
