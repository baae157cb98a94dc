#include "campaign/figure_display.h"

#include <string_view>

namespace repose {
namespace {

struct ShownUnit {
  std::string_view ending;  ///< the longer before what it ends with
  const char* shown;
  double factor;
};

constexpr ShownUnit shown_units[] = {{"_kg_m3", ", kg/m3", 1.0},
                                     {"_J_kg", ", mJ/g", 1.0},
                                     {"_kg_s", ", g/s", 1e3},
                                     {"_kg", ", g", 1e3},
                                     {"_deg_s", ", degrees/s", 1.0},
                                     {"_deg", ", degrees", 1.0},
                                     {"_Nm", ", N m", 1.0},
                                     {"_m", ", mm", 1e3},
                                     {"_s", ", s", 1.0},
                                     {"_J", ", J", 1.0},
                                     {"_N", ", N", 1.0},
                                     {"_Pa", ", Pa", 1.0},
                                     {"_K", ", K", 1.0}};

}  // namespace

FigureDisplay display_of(const std::string& figure) {
  FigureDisplay display{.name = figure, .is_count = true};
  std::string shown;
  for (const ShownUnit& unit : shown_units) {
    if (!figure.ends_with(unit.ending)) continue;
    display.name.erase(figure.size() - unit.ending.size());
    shown = unit.shown;
    display.factor = unit.factor;
    display.is_count = false;
    break;
  }
  for (char& c : display.name) c = c == '_' || c == '.' ? ' ' : c;
  display.name += shown;
  return display;
}

}  // namespace repose
