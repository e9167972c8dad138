// What the loader says, and where.

#include <gtest/gtest.h>

#include "common/scene/load_scene.h"
#include "tests/scene/scene_texts.h"

namespace prosector {
namespace {

struct Case {
  const char* text;
  const char* says;
};

TEST(SceneErrors, NameFileLineFieldAndWhatIsAllowed) {
  const Case cases[] = {
      {"name = \"s\"\n[[soft]]\nname = \"liver\"\nyoungs_modulus = -3\n",
       "test.toml:4: [[soft]] \"liver\": youngs_modulus = -3 Pa: must be in (0, "},
      {"name = \"s\"\ntick_rat = 3\n", "test.toml:2: unknown key \"tick_rat\"; did you mean \"tick_rate\"?"},
      {"name = \"s\"\n\n[hand]\nqqqqqqqqq = 3\n",
       "test.toml:4: [hand]: unknown key \"qqqqqqqqq\"; known: mass"},
      {"tick_rate = 60\n", "name is missing"},
      {"name = \"s\"\n[[rigid]]\nmesh = \"a.obj\"\n", "test.toml:2: [[rigid]] 1: name is missing"},
      {"name = \"s\"\nx = = 1\n", "test.toml:2: "},
      {"name = \"s\"\nsession = 3\n", "test.toml:2: [session] must be a table"},
      {"name = \"s\"\n[rigid]\nname = \"a\"\n", "test.toml:2: rigid must be a list of tables"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nmesh = \"m\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\n",
       "test.toml:6: [[soft]] \"a\": this name is already used by the body in line 3"},
      {"name = \"s\"\n[[rigid]]\nname = \"table\"\nmesh = \"m\"\nparent = \"tabel\"\n",
       "test.toml:5: [[rigid]] \"table\": parent = \"tabel\": no body has this name; did you mean "
       "\"table\"?"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nmesh = \"m\"\nparent = \"b\"\n[[rigid]]\nname = \"b\"\nmesh = "
       "\"m\"\nparent = \"a\"\n",
       "test.toml:5: [[rigid]] \"a\": parent = \"b\": a body can't be its own ancestor"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\n",
       "test.toml:2: [[soft]] \"a\": has 0 of volume, mesh and shape"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nmesh = \"m\"\nshape = \"ball\"\n",
       "test.toml:5: [[soft]] \"a\": has 2"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\n", "no geometry"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nvolume = \"v\"\nlabel = 0\n",
       "test.toml:5: [[soft]] \"a\": label = 0 is the background; allowed: 1 to 65535, or "
       "-1"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nvolume = \"v\"\nlabel = 0\n",
       "test.toml:5: [[rigid]] \"a\": label = 0 is the background"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nmesh = \"m\"\nvolume = \"v\"\n",
       "test.toml:5: [[rigid]] \"a\": has several of mesh, volume, [[rigid.part]]s, and curves or patches: "
       "give one"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nmesh = \"m\"\nlabel = 3\n",
       "test.toml:5: [[rigid]] \"a\": label needs a volume"},
      {"name = \"s\"\n[[rigid]]\nname = \"a\"\nmesh = \"m\"\nrotation = [0, 0, 0, 0]\n", "not all zero"},
      {"name = \"s\"\n[patient]\nright = [1, 0, 0]\nhead = [0.5, 0, 0.5]\n",
       "test.toml:4: [patient]: the patient's directions right and head must be perpendicular and non-zero"},
      {"name = \"s\"\n[patient]\nright = [0, 0, 0]\n",
       "test.toml:2: [patient]: the patient's directions right and head"},
      {"name = \"s\"\n[[light]]\ndirection = [0, 0, 0]\n", "test.toml:3: [[light]] 1: direction is zero"},
      {"name = \"s\"\n[[light]]\nkind = \"laser\"\n", "must be one of: directional, point, spot"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\nmodel = \"\"\n", "model = "},
      {"name = \"\\u0000\"\n", "name = "},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\naccuracy = \"2 mm\"\n",
       "test.toml:5: [[soft]] \"a\": accuracy = '2 mm': must be text: a number in (0, 100] and its unit, "
       "e.g. "
       "\"2 %\""},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\nbudget = 4\n",
       "budget = 4 ms: must be text: a number in (0, 1000] and its unit, e.g. \"2 ms\""},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\naccuracy = \"2 %\"\nbudget = \"4 ms\"\n",
       "test.toml:6: [[soft]] \"a\": accuracy and budget are both given"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"sheet\"\nbudget = \"4 ms\"\n",
       "test.toml:5: [[soft]] \"a\": budget is for solid bodies"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\nbudget = \"4 ms\"\nnewton_iterations = 4\n",
       "test.toml:6: [[soft]] \"a\": the server chooses newton_iterations if budget is given"},
      {"name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\nbudget = \"4 ms\"\nintegrator = \"rk4\"\n",
       "integrator = \"rk4\": allowed with budget: implicit_euler"},
  };
  for (const Case& c : cases)
    EXPECT_NE(complaint(c.text).find(c.says), std::string::npos)
        << complaint(c.text) << "\n  lacks: " << c.says;
}

TEST(SceneErrors, CurvesAndPatches) {
  const std::string rigid = "name = \"s\"\n[[rigid]]\nname = \"a\"\n",
                    soft = "name = \"s\"\n[[soft]]\nname = \"a\"\n";
  const std::string curve = "[[rigid.curve]]\n", patch = "[[rigid.patch]]\n";
  const std::string line = "points = [[0, 0, 0], [1, 0, 0], [2, 1, 0], [3, 0, 0]]\n";
  const std::pair<std::string, const char*> cases[] = {
      {rigid + curve,
       "test.toml:4: [[rigid]] \"a\": curve 1: 0 control points are too few for degree 3: it needs 4"},
      {rigid + curve + line + curve + "kind = \"bezier\"\n",
       "test.toml:6: [[rigid]] \"a\": curve 2: a bezier curve has 0"},
      {rigid + curve + line + "knots = [0, 1]\n",
       "2 knots are given, but a curve of 4 points and degree 3 needs 8"},
      {rigid + curve + line + "knots = [0, 0, 0, 0, 1, 1, 1, 0.5]\n",
       "knot 8 is 0.5, which is below the knot before it, 1"},
      {rigid + curve + line + "knots = [0, 0, 0, 0, 0, 0, 0, 0]\n",
       "knots 2 to 5 are all 0: at most 3 within the curve may be equal"},
      {rigid + curve + line + "weights = [1, 1]\n", "2 weights are given for 4 control points"},
      {rigid + curve + line + "weights = [1, 1, 0, 1]\n",
       "weights = [ 1, 1, 0, 1 ]: must be a list of at most 4096 numbers in"},
      {rigid + curve + "points = [[0, 0, 0], [1, 0]]\n",
       "must be a list of at most 4096 points [x, y, z] in [-1000, 1000]"},
      {rigid + curve + "points = [[0, 0, nan]]\n", "must be a list of at most 4096 points [x, y, z]"},
      {rigid + curve + "kind = \"ellipse\"\nto = 7\n", "at most one full turn"},
      {rigid + curve + "kind = \"parabola\"\nto = 0\n", "must end after it begins"},
      {rigid + curve + line + "tolerance = 0\n", "tolerance = 0 m: must be in [1e-06, 1]"},
      {rigid + patch + line + "columns = 3\n", "4 control points do not fill whole rows of 3 columns"},
      {rigid + patch + line, "along v: 1 control points are too few for degree 3"},
      {rigid + patch + "kind = \"coons\"\n", "0 sides: a Coons patch has 4"},
      {rigid + curve + line + "[[rigid.part]]\n", "has several of mesh"},
      {soft + "shape = \"ball\"\n[[soft.curve]]\n" + line, "[[soft.curve]] needs a rope"},
      {soft + "shape = \"rope\"\n[[soft.curve]]\n" + line + "[[soft.curve]]\n" + line,
       "at most 1 are allowed"},
  };
  for (const auto& [text, says] : cases)
    EXPECT_NE(complaint(text).find(says), std::string::npos) << complaint(text) << "\n  lacks: " << says;
  EXPECT_EQ(complaint(rigid + curve + line + patch + "kind = \"bezier\"\ncolumns = 2\n" + line), "");
}

TEST(SceneErrors, CollisionOfBodies) {
  const auto soft = [](const std::string& lines) {
    return "name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"ball\"\ngroup = \"organs\"\n" + lines;
  };
  const std::pair<const char*, const char*> cases[] = {
      {"collision = \"ball\"\n", "must be one of: none, sphere, aabb, obb, hull, mesh"},
      {"[[soft]]\nname = \"b\"\nshape = \"rope\"\ncollision = \"hull\"\n", "a rope has no hull"},
      {"collision = \"hull\"\nself_contact = true\n",
       "test.toml:7: [[soft]] \"a\": self_contact needs collision = \"mesh\": collision is \"hull\""},
      {"refine = \"finger\"\n", "must be one of: none, touch"},
      {"refine = \"touch\"\nelement = \"tet10\"\n",
       "test.toml:6: [[soft]] \"a\": refine = \"touch\" needs linear elements: element is \"tet10\""},
      {"[[soft]]\nname = \"b\"\nshape = \"rope\"\nrefine = \"touch\"\n", "a rope has no tetrahedra"},
      {"refine = \"touch\"\ncell = 0.01\nrefine_cell = 0.01\n",
       "refine_cell is 0.01 m; it must be smaller than cell"},
      {"grade = \"rim\"\n", "must be one of: none, rims"},
      {"[[soft]]\nname = \"b\"\nshape = \"sheet\"\ngrade = \"rims\"\n", "a sheet has no tetrahedra"},
      {"touches = \"organs\"\n", "must be a list of names"},
      {"touches = [\"organs\", 3]\n", "must be a list of names"},
      {"touches = [\"default\", \"organ\"]\n",
       "test.toml:6: [[soft]] \"a\": touches \"organ\": no body is in this group; did you mean \"organs\"?"},
      {"collision = \"none\"\ncontinuous = true\n",
       "test.toml:7: [[soft]] \"a\": continuous needs a collision shape"},
  };
  for (const auto& [lines, says] : cases)
    EXPECT_NE(complaint(soft(lines)).find(says), std::string::npos) << complaint(soft(lines));
  EXPECT_EQ(complaint(soft("touches = [\"default\", \"hand\", \"organs\"]\n")), "");
}

TEST(SceneErrors, TooManyCollisionGroups) {
  std::string text = "name = \"s\"\n";
  for (std::size_t i = 0; i < max_collision_groups; ++i) {
    if (i == max_collision_groups - 2) {
      EXPECT_EQ(complaint(text), "") << "\"default\" and \"hand\" are the other two";
    }
    text += "[[rigid]]\nname = \"b" + std::to_string(i) + "\"\nmesh = \"m\"\ngroup = \"g" +
            std::to_string(i) + "\"\n";
  }
  EXPECT_NE(complaint(text).find("[[rigid]] \"b30\": group = \"g30\": 32 collision groups exist already"),
            std::string::npos)
      << complaint(text);
}

TEST(SceneErrors, TooManyLights) {
  std::string text = "name = \"s\"\n";
  for (std::size_t i = 0; i <= max_lights; ++i) text += "[[light]]\n";
  EXPECT_NE(complaint(text).find("at most 16 are allowed"), std::string::npos) << complaint(text);
}

TEST(SceneErrors, MissingFileAndFolder) {
  EXPECT_THROW(load_scene("no/such/scene.toml"), InputError);
  EXPECT_THROW(load_scene("/"), InputError);
}

TEST(SceneErrors, NeedsAreNumbersWithUnitsAndNoteWhatIsFixed) {
  for (const char* text : {"accuracy = \"1.5 %\"", "accuracy = \"1.5%\""}) {
    const SceneDesc scene = parse_scene(scene_with("[[soft]]", text), "test.toml");
    EXPECT_EQ(scene.soft[0].choice.accuracy.value, 1.5);
    EXPECT_FALSE(scene.soft[0].choice.fixed.model);
  }
  const SceneDesc scene =
      parse_scene(scene_with("[[soft]]", "budget = \"4 ms\"\nmodel = \"fem_linear\"\ncell = 0.02"), "t.toml");
  EXPECT_EQ(scene.soft[0].choice.budget.value, 4);
  EXPECT_TRUE(scene.soft[0].choice.fixed.model);
  EXPECT_TRUE(scene.soft[0].choice.fixed.cell);
  EXPECT_FALSE(scene.soft[0].choice.fixed.solver);
  for (const char* bad : {"\"ms\"", "\"-1 ms\"", "\"nan ms\"", "\"4 ms \"", "\"4 s\"", "\"0 ms\"", "\"\""})
    EXPECT_NE(complaint(scene_with("[[soft]]", std::string("budget = ") + bad)), "") << bad;
}

TEST(SceneErrors, RotationIsNormalised) {
  const SceneDesc scene = parse_scene(scene_with("[[soft]]", "rotation = [0, 1e300, 0, 0]"), "test.toml");
  EXPECT_DOUBLE_EQ(scene.soft[0].pose.q.x(), 1);
}

TEST(SceneHints, ASceneWithoutLightIsSaidToBeDark) {
  const std::string dark = "name = \"s\"\n";
  const auto hints = scene_hints(parse_scene(dark, "f"));
  ASSERT_EQ(hints.size(), 1u);
  EXPECT_NE(hints[0].find("no light"), std::string::npos);
  // What the hint says to write is what helps.
  const std::string light = "[[light]]\nkind = \"directional\"\ndirection = [0, -1, -0.5]\n";
  EXPECT_NE(hints[0].find("kind = \"directional\" and direction = [0, -1, -0.5]"), std::string::npos);
  EXPECT_TRUE(scene_hints(parse_scene(dark + light, "f")).empty());
}

}  // namespace
}  // namespace prosector
