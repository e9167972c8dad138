// What the hash of a compiled scene depends on: each key as its row in the field tables says.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>
#include <type_traits>

#include "common/anatomy/kuhn_box.h"
#include "common/byte_stream.h"
#include "common/scene/field_values.h"
#include "common/scene/load_scene.h"
#include "common/scene/scene_fields.h"
#include "server/physics/stations/compile/compile.h"
#include "tests/anatomy/files.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

namespace files = testing_files;

std::string gmsh(const TetMesh& mesh) {
  std::ostringstream out;
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.positions.size() << "\n";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    out << i + 1 << " " << mesh.positions[i].transpose() << "\n";
  out << "$EndNodes\n$Elements\n" << mesh.tets.size() << "\n";
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    out << t + 1 << " 4 2 0 1";
    for (const std::uint32_t node : mesh.tets[t]) out << " " << node + 1;
    out << "\n";
  }
  out << "$EndElements\n";
  return out.str();
}

/// A tetrahedron as a surface file, `size` long along its edges.
std::string off(double size) {
  std::ostringstream out;
  out << "OFF\n4 4 6\n0 0 0\n"
      << size << " 0 0\n0 " << size << " 0\n0 0 " << size << "\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  return out.str();
}

/// A folder with two files of each kind that a scene may name, which differ: one.KIND and other.KIND.
class Files {
 public:
  Files() {
    const auto file = [&](const char* name) { return folder_.path / name; };
    constexpr int n = files::two_balls_side;
    auto voxels = files::two_balls_voxels();
    files::write(file("one.inr"), files::inrimage(n, n, n, {2, 2, 2}, voxels));
    files::write(file("other.inr"), files::inrimage(n, n, n, {1.5, 2, 2}, voxels));
    files::write(file("one.msh"), gmsh(kuhn_box({0.06, 0.03, 0.06}, 3, 2, 3)));
    files::write(file("other.msh"), gmsh(kuhn_box({0.06, 0.03, 0.05}, 3, 2, 3)));
    files::write(file("one.off"), off(0.1));
    files::write(file("other.off"), off(0.12));
    files::write(file("one.csv"), "id,name\n7,liver\n9,femur\n");
    files::write(file("other.csv"), "id,name\n7,liver\n");
  }
  std::filesystem::path scene() const { return folder_.path / "scene.toml"; }

 private:
  files::TempDir folder_;
};

/// Scenes in which every key that is hashed acts on something.
std::vector<std::string> scene_texts() {
  const std::string four = "points = [[0, 0, 0], [0.05, 0, 0], [0.1, 0.05, 0], [0.15, 0, 0]]\n";
  const std::string curve = four + "weights = [1, 2, 1, 1]\ndegree = 2\nknots = [0, 0, 0, 0.4, 1, 1, 1]\n";
  const std::string arc = "kind = \"ellipse\"\nfrom = 0.5\nto = 2\n";
  std::string net = "points = [";
  for (int v = 0; v < 3; ++v)
    for (int u = 0; u < 4; ++u) net += fmt::format("[{}, {}, {}], ", 0.04 * u, 0.01 * (u % 2) * v, 0.05 * v);
  net += "]\ncolumns = 4\ndegree_u = 2\ndegree_v = 1\nposition = [0, 1, 0]\n";
  const std::string knots =
      "weights = [1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\nknots_u = [0, 0, 0, 0.4, 1, 1, 1]\nknots_v = [0, 0, "
      "0.4, 1, 1]\n";
  const std::string side =
      "kind = \"bspline\"\npoints = [[0.02, 0, 0], [0.05, 0.03, 0], [0.05, 0.06, 0], [0.02, 0.1, 0]]\n";
  const std::string bowl = "kind = \"revolved\"\n";
  const std::string rope =
      "[[soft]]\nname = \"rope\"\nshape = \"rope\"\nmodel = \"mass_spring\"\nsize = [0.1, 0.01, "
      "0.01]\n[[soft.curve]]\n";
  const std::string sheet =
      "[[soft]]\nname = \"sheet\"\nshape = \"sheet\"\nmodel = \"mass_spring\"\n[[soft.patch]]\n";
  return {
      "[hand]\n[room]\n[[rigid]]\nname = \"box\"\nbreak_force = 5\ncollision = \"mesh\"\n"
      "[[rigid.part]]\nrounding = 0.01\n[[rigid.fracture]]\n[[rigid.edge]]\n"
      "[[soft]]\nname = \"block\"\nshape = \"block\"\ncell = 0.03\nsurface_cell = 0.03\nposition = [0, 1, "
      "0]\n"
      "[[soft.attach]]\ncenter = [0, 1, 0]\n[[soft.region]]\n[[soft.relaxation]]\n",
      "[[rigid]]\nname = \"mesh\"\nmesh = \"one.off\"\n",
      "[[rigid]]\nname = \"stand-in\"\nmesh = \"none.off\"\nfallback = \"ball\"\nsurface_cell = 0.02\n",
      "[[rigid]]\nname = \"volume\"\nvolume = \"one.inr\"\nlabel = 7\nsurface_cell = 0.01\n",
      "[[rigid]]\nname = \"grey\"\nvolume = \"one.inr\"\nthreshold = 6\nsurface_cell = 0.01\n",
      "[[rigid]]\nname = \"tube\"\n[[rigid.curve]]\n" + curve,
      "[[rigid]]\nname = \"tube\"\n[[rigid.curve]]\n" + four,
      "[[rigid]]\nname = \"arc\"\n[[rigid.curve]]\n" + arc,
      "[[rigid]]\nname = \"slab\"\n[[rigid.patch]]\n" + net + knots,
      "[[rigid]]\nname = \"slab\"\n[[rigid.patch]]\n" + net,
      "[[rigid]]\nname = \"bowl\"\n[[rigid.patch]]\n" + bowl + "[[rigid.patch.side]]\n" + side,
      "[[rigid]]\nname = \"bowl\"\n[[rigid.patch]]\n" + bowl + "[[rigid.patch.side]]\n" + side +
          "weights = [1, 2, 1, 1]\ndegree = 2\nknots = [0, 0, 0, 0.4, 1, 1, 1]\n",
      "[[soft]]\nname = \"mesh\"\nmesh = \"one.msh\"\n",
      "[[soft]]\nname = \"stand-in\"\nmesh = \"none.msh\"\nfallback = \"ball\"\ncell = 0.03\nsurface_cell = "
      "0.03\n",
      "[[soft]]\nname = \"volume\"\nvolume = \"one.inr\"\nlabel = 7\ncell = 0.01\nsurface_cell = 0.01\n",
      "[[soft]]\nname = \"grey\"\nvolume = \"one.inr\"\nthreshold = 6\ncell = 0.01\nsurface_cell = 0.01\n"
      "max_volume_error = \"90 %\"\n",
      "[[soft]]\nname = \"graded\"\nshape = \"block\"\ncell = 0.02\nsurface_cell = 0.02\n[[soft.attach]]\n"
      "center = [0, -0.05, 0]\nradius = 0.03\n",
      rope + curve,
      rope + four,
      rope + arc,
      sheet + net + knots,
      sheet + net,
      sheet + bowl + "[[soft.patch.side]]\n" + side,
      sheet + bowl + "[[soft.patch.side]]\n" + side +
          "weights = [1, 2, 1, 1]\ndegree = 2\nknots = [0, 0, 0, 0.4, 1, 1, 1]\n",
      "[[atlas]]\nvolume = \"one.inr\"\nlabels = \"one.csv\"\ncell = 0.01\nsurface_cell = 0.005\n",
  };
}

SceneDesc scene_of(const std::string& text, const Files& files) {
  return parse_scene("name = \"s\"\n" + text, files.scene());
}

/// Visits every struct of a scene with its table.
void for_each_item(const Table& table, void* object, const std::function<void(const Table&, void*)>& visit) {
  visit(table, object);
  for (const Child& child : table.children)
    for (void* item : child.items.present(object)) for_each_item(child.table(), item, visit);
}

/// Each puts the `attempt`-th other value that the field may hold there; false: it has no more.
template <class Number>
requires(std::is_arithmetic_v<Number> &&
         !std::is_same_v<Number, bool>) bool put(const Field& field, std::size_t attempt, Number& x) {
  const auto now = static_cast<double>(x);
  for (const double other : {1.1 * now + 0.013, 0.7 * now, now + 1, now - 1}) {
    const auto put = static_cast<Number>(other);
    if (put == x || !field.range.contains(static_cast<double>(put)) || attempt-- > 0) continue;
    x = put;
    return true;
  }
  return false;
}
bool put(const Field& field, std::size_t attempt, Quantity& x) {
  return put(field, attempt, x.value);
}
bool put(const Field&, std::size_t attempt, bool& x) {
  x = !x;
  return attempt == 0;
}
bool put(const Field& field, std::size_t attempt, Vec3& x) {
  return attempt < 3 && put(field, 0, x[static_cast<int>(attempt)]);
}
bool put(const Field&, std::size_t attempt, Quat& x) {
  x = x * Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
  return attempt == 0;
}
bool put(const Field& field, std::size_t attempt, std::uint8_t& x) {  // an enumeration
  if (attempt >= field.words.size()) return false;
  x = static_cast<std::uint8_t>(attempt);
  return true;
}
bool put(const Field& field, std::size_t attempt, std::string& x) {
  if (!field.words.empty()) {
    if (attempt >= field.words.size()) return false;
    x = field.words[attempt];
    return true;
  }
  if (field.text == Text::identifier) {  // a model, an integrator or a solver
    const char* others[] = {"fem_stvk", "bdf2", "multigrid"};
    if (attempt >= std::size(others)) return false;
    x = others[attempt];
    return true;
  }
  if (const std::size_t dot = x.rfind("one."); dot != std::string::npos)
    x.replace(dot, 3, "other");
  else
    x += "_";
  return attempt == 0;
}
bool put(const Field&, std::size_t attempt, std::vector<std::string>& x) {
  const std::vector<std::string> others[] = {{"liver"}, {"default"}};
  if (attempt >= std::size(others)) return false;
  x = others[attempt];
  return true;
}
bool put(const Field&, std::size_t attempt, std::vector<double>& x) {
  if (attempt > 0 || x.empty()) return false;
  x[x.size() / 2] *= 1.1;
  return true;
}
bool put(const Field&, std::size_t attempt, std::vector<Vec3>& x) {
  if (attempt > 0 || x.empty()) return false;
  x.back() += Vec3(0.003, 0, 0);
  return true;
}
bool change(const Field& field, const FieldRef& ref, std::size_t attempt) {
  return std::visit([&](auto* x) { return put(field, attempt, *x); }, ref);
}

std::vector<std::uint8_t> values(const SceneDesc& scene) {
  ByteWriter out;
  add_values(scene, out);
  return out.take();
}

CompileOptions on_one_thread() {
  CompileOptions out;
  out.threads = 1;
  return out;
}

/// Returns the hash of the compiled scene; none where it can't be compiled.
std::optional<std::string> compiled_hash(const SceneDesc& scene) {
  try {
    return to_hex(compile(scene, on_one_thread()).model.hash);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

using Keys = std::map<std::string, bool>;  // by "TABLE key": whether a change of it changed the hash

/// Changes each key of `hashed` in turn, in each struct of the scene that has it, and notes the ones that
/// change what `hash` returns. Keys that did so before are left out.
template <class Hash>
void try_each(const std::string& text, const Files& files, Hashed hashed, Keys& keys, const Hash& hash) {
  const SceneDesc scene = scene_of(text, files);
  const auto before = hash(scene);
  ASSERT_NE(before, decltype(before){}) << text;
  std::size_t items = 0;
  SceneDesc counted = scene;
  for_each_item(scene_table(), &counted, [&](const Table&, void*) { ++items; });
  for (std::size_t i = 0; i < items; ++i) {
    const auto with_item = [&](SceneDesc& of, const std::function<void(const Table&, void*)>& use) {
      std::size_t at = 0;
      for_each_item(scene_table(), &of, [&](const Table& table, void* item) {
        if (at++ == i) use(table, item);
      });
    };
    std::vector<const Field*> fields;
    std::string_view name;
    with_item(counted, [&](const Table& table, void*) {
      name = table.name;
      for (const Field& field : table.fields) fields.push_back(&field);
    });
    for (const Field* field : fields) {
      if (field->hashed != hashed) continue;
      bool& found = keys[fmt::format("{} {}", name, field->key)];
      for (std::size_t attempt = 0; !found; ++attempt) {
        SceneDesc changed = scene;
        bool more = true;
        with_item(changed,
                  [&](const Table&, void* item) { more = change(*field, field->in(item), attempt); });
        if (!more) break;
        const auto after = hash(changed);
        found = after != decltype(after){} && after != before;
      }
    }
  }
}

void expect_all(const Keys& keys) {
  for (const auto& [key, found] : keys) EXPECT_TRUE(found) << key << ": no change of it changed the hash";
}

Keys keys_of(Hashed hashed) {
  Keys out;
  const std::function<void(const Table&)> visit = [&](const Table& table) {
    for (const Field& field : table.fields)
      if (field.hashed == hashed) out[fmt::format("{} {}", table.name, field.key)] = false;
    for (const Child& child : table.children) visit(child.table());
  };
  visit(scene_table());
  return out;
}

TEST(SceneHash, EveryKeyHashedByValueChangesIt) {
  const Files files;
  Keys keys = keys_of(Hashed::by_value);
  for (const std::string& text : scene_texts()) try_each(text, files, Hashed::by_value, keys, values);
  expect_all(keys);
}

TEST(SceneHash, EveryKeyHashedAsCompiledChangesIt) {
  const Files files;
  Keys keys = keys_of(Hashed::compiled);
  for (const std::string& text : scene_texts()) try_each(text, files, Hashed::compiled, keys, compiled_hash);
  expect_all(keys);
}

/// A hand presses the block, with every key changed that isn't hashed: the same motion, bit for bit.
TEST(SceneHash, KeysThatAreNotHashedChangeNoTick) {
  const Files files;
  const SceneDesc scene =
      scene_of(scene_texts().front() + "[session]\n[camera]\n[patient]\n[[light]]\n", files);
  SceneDesc changed = scene;
  int count = 0;
  for_each_item(scene_table(), &changed, [&](const Table& table, void* item) {
    for (const Field& field : table.fields)
      if (field.hashed == Hashed::not_hashed && field.key != "accuracy" && field.key != "budget")
        count += change(field, field.in(item), field.words.empty() ? 0 : 1);
  });
  EXPECT_GT(count, 40);
  ASSERT_EQ(compiled_hash(scene), compiled_hash(changed));
  Simulation one(scene, on_one_thread()), other(changed, on_one_thread());
  const double top = 1.05;
  for (int tick = 0; tick < 40; ++tick) {
    const Vec3 at(0, top + 0.06 - 0.002 * tick, 0);
    const TickInput input = tick == 0 ? appear(at) : target(at);
    one.step(input);
    other.step(input);
    ASSERT_EQ(one.state_hash(), other.state_hash()) << tick;
  }
}

TEST(SceneHash, ACheckpointOfAPartThatSnapsFromElsewhereIsRefused) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  scene.soft[0].part = true;
  const auto saved = Simulation(scene, options()).checkpoint();
  EXPECT_NO_THROW(Simulation(scene, options()).restore(saved));
  scene.soft[0].snap *= 2;
  EXPECT_THROW(Simulation(scene, options()).restore(saved), InputError);
  scene.soft[0].snap /= 2;
  scene.soft[0].part = false;
  EXPECT_THROW(Simulation(scene, options()).restore(saved), InputError);
}

}  // namespace
}  // namespace prosector::test
