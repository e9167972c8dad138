#pragma once
// Materials of anatomical parts, selected by the part's name: starting values for generated scenes.

#include <string>
#include <string_view>
#include <vector>

#include "common/math.h"
#include "common/scene/scene.h"

namespace prosector {

/// A material of anatomical parts, with starting values for generated scenes. Measured values of one organ
/// differ by a factor of two and more.
struct Material {
  std::string_view name;
  std::vector<std::string_view> words;  // lower-case words in the names of parts made of it
  bool rigid = false;                   // bone, teeth: bodies of this material are rigid
  double youngs_modulus = 0;            // Pa
  double density = 1000;                // kg/m³
  double toughness = 0;                 // J/m²
  Vec3 color = Vec3::Zero();            // linear red, green, blue
  double wetness = 0;
  double usual_size = 0;  // m: longest side of an adult's part, about
};

/// Returns the table of materials of anatomical parts. The last entry, "tissue", is used for part names
/// without a known word.
const std::vector<Material>& materials();

/// Returns the names of all materials, which are the allowed values of a scene's `material` key.
std::vector<std::string_view> material_names();

/// Returns the material of anatomical parts with that name; null if there is none.
const Material* find_material(std::string_view name);

/// Returns the material that is selected by a word of the anatomical part's name, such as "kidney" in
/// "left_kidney 2". Returns "tissue" if no word is known.
const Material& material_for_part(std::string_view part);

/// Sets a body's mechanical and visual properties in its description to those of the material.
void apply_material(const Material& material, SoftDesc& body);
void apply_material(const Material& material, RigidDesc& body);

}  // namespace prosector
