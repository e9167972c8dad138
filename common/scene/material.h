#pragma once
// What parts of a body are made of, by name: starting values for scenes that nobody has written by hand.

#include <string>
#include <string_view>
#include <vector>

#include "common/math.h"
#include "common/scene/scene.h"

namespace prosector {

/// A material. Values are starting values: measured ones of one organ differ by a factor of two and more.
struct Material {
  std::string_view name;
  std::vector<std::string_view> words;  // of names of parts that are made of it, small letters
  bool rigid = false;                   // bone, teeth: bodies of it keep their shape
  double youngs_modulus = 0;            // Pa
  double density = 1000;                // kg/m³
  double toughness = 0;                 // J/m²
  Vec3 color = Vec3::Zero();            // linear red, green, blue
  double wetness = 0;
  double usual_size = 0;  // m: longest side of a part of an adult's, about
};

/// Returns the table. Its last entry, "tissue", is what a part is made of whose name says nothing.
const std::vector<Material>& materials();

/// Returns the names in the table, for a scene's keys.
std::vector<std::string_view> material_names();

/// Returns the material called so; null: there is none.
const Material* find_material(std::string_view name);

/// Returns what a part is made of by a word of its name ("left_kidney 2": kidney); else "tissue".
const Material& material_of(std::string_view part);

/// Puts the material into a body's description: mechanics and looks.
void make_of(const Material& material, SoftDesc& body);
void make_of(const Material& material, RigidDesc& body);

}  // namespace prosector
