#pragma once

#include <string>
#include <vector>

#include "import/imported_scene.h"

namespace repose {

/// A material of the deck: a type of atoms with one density, or a type of walls that cohere or resist rolling unlike
/// the grains.
struct MaterialUsed {
  std::string name = {};
  int type = 1;
  double density = 0.0;  ///< kg/m3
  bool is_of_grains = true;
  bool slides = true;  ///< walls alone: whether there is friction
  bool coheres = true;
  bool rolls = true;
  Place place = {};
};

/// All materials that grains and walls of a script have.
class MaterialsUsed {
 public:
  /// DeckError at the line of a wall whose model is another one than that of the grains.
  explicit MaterialsUsed(const ImportedScene& scene);

  const std::vector<MaterialUsed>& all() const { return materials_; }
  const std::string& of_grains(int type, double density) const;
  const std::string& of_wall(const ScriptWall& wall, int type) const;
  /// The models of grains and walls as one: what is off somewhere is off by its coefficients there.
  const ScriptModel& model() const { return model_; }

 private:
  void add_grains(int type, double density, const Place& place);
  void add_wall(const ScriptWall& wall, int type);
  void unite(const ScriptModel& other);
  const MaterialUsed* find_wall(const ScriptWall& wall, int type) const;

  ScriptModel pair_;
  ScriptModel model_;
  std::vector<MaterialUsed> materials_;
};

}  // namespace repose
