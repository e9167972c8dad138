#include "common/scene/material.h"

#include <algorithm>

namespace prosector {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (static_cast<unsigned char>(c) & 0x80) != 0;
}

/// Returns the words of a part's name in lower case. Words are separated by characters that aren't letters,
/// or start at a capital after a lower-case letter.
std::vector<std::string> words_in_name(std::string_view part) {
  std::vector<std::string> out(1);
  bool was_small = false;
  for (char c : part) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) c = static_cast<char>(c - 'A' + 'a');
    if (!is_letter(c) || (capital && was_small)) out.emplace_back();
    if (is_letter(c)) out.back() += c;
    was_small = is_letter(c) && !capital;
  }
  return out;
}

// Stiffness, density, toughness and size are starting values. Stiffness of liver, kidney, spleen and
// pancreas: magnetic resonance elastography (E = 3G). Densities: Kaye & Laby. Toughness: liver from Gokgol et
// al. 2012, also used for soft parts without a measured value. Hollow organs are modelled as solid, since
// their walls are thinner than a cell.

/// Returns the materials of organs of the abdomen and pelvis.
std::vector<Material> abdominal_organs() {
  return {
      {"liver", {"liver", "hepar"}, false, 5400, 1060, 164, {0.35, 0.08, 0.055}, 0.5, 0.22},
      {"kidney", {"kidney", "kidneys", "ren"}, false, 15000, 1050, 164, {0.33, 0.1, 0.08}, 0.4, 0.11},
      {"spleen", {"spleen", "lien"}, false, 10800, 1054, 164, {0.28, 0.06, 0.09}, 0.4, 0.12},
      {"pancreas", {"pancreas"}, false, 3600, 1045, 164, {0.65, 0.42, 0.26}, 0.4, 0.17},
      {"gallbladder", {"gallbladder", "biliaris"}, false, 8000, 1060, 164, {0.17, 0.28, 0.1}, 0.5, 0.09},
      {"stomach",
       {"stomach", "gaster", "esophagus", "oesophagus"},
       false,
       10000,
       1050,
       500,
       {0.6, 0.28, 0.24},
       0.5,
       0.25},
      {"bowel",
       {"bowel", "colon", "intestine", "duodenum", "jejunum", "ileum", "rectum", "appendix"},
       false,
       8000,
       1045,
       500,
       {0.62, 0.3, 0.26},
       0.5,
       0.4},
      {"bladder", {"bladder", "uterus", "prostate"}, false, 10000, 1040, 500, {0.6, 0.34, 0.3}, 0.5, 0.1}};
}

/// Returns the materials of organs of the chest and head.
std::vector<Material> chest_and_head_organs() {
  return {{"heart",
           {"heart", "cor", "myocardium", "atrium", "ventricle"},
           false,
           20000,
           1044,
           550,
           {0.38, 0.07, 0.06},
           0.5,
           0.13},
          {"lung", {"lung", "lungs", "pulmo"}, false, 3000, 288, 164, {0.62, 0.33, 0.33}, 0.3, 0.25},
          {"brain",
           {"brain", "cerebrum", "cerebellum", "brainstem", "cortex", "gyrus", "hippocampus", "thalamus",
            "amygdala", "putamen", "caudate"},
           false,
           3000,
           1036,
           80,
           {0.62, 0.42, 0.38},
           0.4,
           0.17}};
}

/// Returns the materials of tissues of the whole body, bone among them.
std::vector<Material> body_tissues() {
  return {
      {"fat", {"fat", "adipose"}, false, 3000, 920, 500, {0.75, 0.58, 0.2}, 0.3, 0.2},
      {"muscle",
       {"muscle", "muscles", "musculus", "diaphragm", "tongue"},
       false,
       20000,
       1047,
       1000,
       {0.36, 0.06, 0.05},
       0.3,
       0.3},
      {"skin", {"skin", "cutis"}, false, 100000, 1110, 2000, {0.72, 0.45, 0.34}, 0, 1.7},
      {"vessel",
       {"vessel", "vessels", "aorta", "artery", "vein", "vena", "cava", "trachea", "ureter"},
       false,
       400000,
       1050,
       300,
       {0.55, 0.12, 0.1},
       0.3,
       0.3},
      {"cartilage",
       {"cartilage", "meniscus", "disc"},
       false,
       500000,
       1100,
       1000,
       {0.72, 0.72, 0.66},
       0.3,
       0.05},
      {"bone",
       {"bone", "bones",   "skull",    "cranium",   "mandible", "vertebra", "vertebrae", "spine", "rib",
        "ribs", "sternum", "clavicle", "clavicula", "scapula",  "humerus",  "radius",    "ulna",  "pelvis",
        "hip",  "sacrum",  "femur",    "patella",   "tibia",    "fibula",   "foot",      "tooth", "teeth"},
       true,
       0,
       1920,
       0,
       {0.78, 0.72, 0.58},
       0,
       0.3}};
}

/// Returns the material of parts whose name has no known word.
Material fallback_material() {
  return {"tissue", {}, false, 5400, 1060, 164, {0.5, 0.2, 0.16}, 0.4, 0.15};
}

}  // namespace

const std::vector<Material>& materials() {
  static const std::vector<Material> table = [] {
    std::vector<Material> out;
    for (const auto& group : {abdominal_organs(), chest_and_head_organs(), body_tissues()})
      out.insert(out.end(), group.begin(), group.end());
    out.push_back(fallback_material());
    return out;
  }();
  return table;
}

std::vector<std::string_view> material_names() {
  std::vector<std::string_view> out;
  for (const Material& material : materials()) out.push_back(material.name);
  return out;
}

const Material* find_material(std::string_view name) {
  const auto found = std::ranges::find(materials(), name, &Material::name);
  return found == materials().end() ? nullptr : &*found;
}

const Material& material_for_part(std::string_view part) {
  const std::vector<std::string> words = words_in_name(part);
  for (const Material& material : materials())
    for (const std::string& word : words)
      if (std::ranges::find(material.words, word) != material.words.end()) return material;
  return materials().back();
}

void apply_material(const Material& material, SoftDesc& body) {
  body.material.youngs_modulus = material.youngs_modulus;
  body.material.density = material.density;
  body.material.toughness = material.toughness;
  body.appearance.surface = Surface::tissue;
  body.appearance.color = material.color;
  body.appearance.wetness = material.wetness;
}

void apply_material(const Material& material, RigidDesc& body) {
  body.material.density = material.density;
  body.appearance.surface = material.rigid ? Surface::bone : Surface::tissue;
  body.appearance.color = material.color;
  body.appearance.wetness = material.wetness;
}

}  // namespace prosector
