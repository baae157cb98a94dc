#include "thermal/plane_source/tps_deck.h"

#include <fmt/core.h>

#include "thermal/tool_deck.h"

namespace repose::thermal {

template <class V>
void describe(V& v, SensorDeck& s) {
  v("type", s.type, Unit::none, any_value, optional, "concentric rings, or their limit, a disc");
  v("radius", s.radius, Unit::metre, above(0), required, "of the heated disc");
  v("radius_deviation", s.radius_deviation, Unit::none, from_to_below(0, 1), optional, "relative standard deviation");
  const bool rings = s.type == SourceType::rings;
  v("rings", s.rings, Unit::none, from_to(1, 60), optional.when(rings, "type = rings"), "number of rings");
  v("cutoff", s.cutoff, Unit::none, from_to(SourceFunction::min_tau, 0.1), optional.when(rings, "type = rings"),
    "where the integral over sigma begins");
  v("resistance", s.thermometer.resistance, Unit::ohm, above(0), optional_else("none"), "of the spiral at time 0");
  v("resistance_coefficient", s.thermometer.coefficient, Unit::per_kelvin, above(0), optional_else("none"),
    "of the spiral's resistance with temperature");
}

template <class V>
void describe(V& v, EvaluationDeck& e) {
  v("power", e.power, Unit::watt, above(0), optional_else("the file's column"), "into the sensor");
  v("power_deviation", e.power_deviation, Unit::none, from_to_below(0, 1), optional, "relative standard deviation");
  v("leave_out_first", e.first, Unit::none, from_to(0, 1e9), optional, "points at the beginning");
  v("leave_out_last", e.last, Unit::none, from_to(0, 1e9), optional, "points at the end");
  v("bulk_density", e.bulk_density, Unit::density, above(0), optional_else("none"),
    "of the sample, for the mass heat capacity");
}

template <class V>
void describe(V& v, TpsLimits& l) {
  v("available_depth", l.available_depth, Unit::metre, above(0), required, "from the sensor to the sample's boundary");
  v("min_rise", l.min_rise, Unit::kelvin, at_least(0), optional, "least total rise");
  v("max_rise", l.max_rise, Unit::kelvin, above(0), optional, "greatest total rise");
  v("max_mean_deviation", l.max_mean_deviation, Unit::kelvin, above(0), optional, "of the residuals");
  v("min_left_out", l.min_left_out, Unit::none, from_to(0, 1e9), optional, "points at the beginning");
  v("min_points", l.min_points, Unit::none, from_to(0, 1e9), optional, "that remain");
  v("drift_duration", l.drift_duration, Unit::second, at_least(0), optional, "recorded before time 0");
  v("max_drift", l.max_drift, Unit::none, above(0), optional, "over the transient's time, per total rise");
  v("max_jump", l.max_jump, Unit::none, above(0), optional, "between residuals, in standard deviations");
  v("min_runs_deviate", l.min_runs_deviate, Unit::none, any_value, optional, "of the number of runs of one sign");
  v("max_straightness", l.max_straightness, Unit::none, above(0), optional, "1 - R^2 of the line");
  v("max_power_deviation", l.max_power_deviation, Unit::none, above(0), optional, "of the power from its mean");
}

template <class V>
void describe(V& v, RepeatsDeck& r) {
  v("min", r.min, Unit::none, from_to(1, 1000), optional, "measurements that there should be");
  v("interval", r.interval, Unit::second, at_least(0), optional, "from one to the next, at least");
  v("starts", r.starts, Unit::second, any_value, optional, "when they began, in the order of the files");
}

template <class V>
void describe(V& v, Insulation& i) {
  v("thickness", i.thickness, Unit::metre, above(0), required, "on each side of the spiral");
  v("conductivity", i.conductivity, Unit::conductivity, above(0), required, "of the insulation");
  v("diffusivity", i.diffusivity, Unit::diffusivity, above(0), required, "of the insulation");
}

template <class V>
void describe(V& v, Layer& l) {
  v("thickness", l.thickness, Unit::metre, above(0), required, "on each side of the spiral");
  v("conductivity", l.conductivity, Unit::conductivity, above(0), required, "through the layer");
  v("radial_conductivity", l.radial_conductivity, Unit::conductivity, above(0), optional_else("conductivity"),
    "along the layer");
  v("volumetric_heat", l.volumetric_heat, Unit::volumetric_heat, above(0), required, "of the layer");
}

template <class V>
void describe(V& v, Heater& h) {
  v("thickness", h.thickness, Unit::metre, above(0), required, "of the metal");
  v("volumetric_heat", h.volumetric_heat, Unit::volumetric_heat, above(0), required, "of the metal");
  v("coverage", h.coverage, Unit::none, above_to(0, 1), optional, "share of the disc that the strips cover");
}

template <class V>
void describe(V& v, SyntheticDeck& d) {
  SyntheticTransient& s = d.transient;
  v("conductivity", s.conductivity, Unit::conductivity, above(0), required, "of the sample");
  v("volumetric_heat", s.volumetric_heat, Unit::volumetric_heat, above(0), required, "of the sample");
  v("duration", s.duration, Unit::second, above(0), required, "of the transient");
  v("points", s.points, Unit::none, from_to(1, 1e6), optional, "of the transient");
  v("noise", s.noise, Unit::none, from_to(0, 1), optional, "standard deviation over the sample's rise");
  v("drift", s.drift, Unit::heating_rate, any_value, optional, "of the sample");
  v("idle_duration", s.idle_duration, Unit::second, at_least(0), optional, "recorded before time 0");
  v("idle_points", s.idle_points, Unit::none, from_to(0, 1e6), optional, "recorded before time 0");
  v("seed", s.seed, Unit::none, from_to(0, 1e18), optional, "of the noise");
  v.section("insulation", s.insulation, optional, "between spiral and sample");
  v.sections("layer", s.layers, optional, "between spiral and sample, from the spiral outwards; instead of insulation");
  v.section("heater", s.heater, optional, "the metal of the spiral");
}

template <class V>
void describe(V& v, TpsDeck& d) {
  v("title", d.title, Unit::none, any_value, optional, "free text");
  v.section("sensor", d.sensor, required, "the plane source");
  v.section("evaluation", d.evaluation, optional, "how a transient is evaluated");
  v.section("criteria", d.limits, required, "what a good transient keeps to");
  v.section("repeats", d.repeats, optional, "how often and when it was measured");
  v.section("synthetic", d.synthetic, optional, "a transient to be made up");
}

namespace {

void check(TpsDeck& deck, DeckErrors& errors) {
  if (deck.limits.max_rise <= deck.limits.min_rise)
    errors.add("criteria.max_rise", "\"max_rise\" of [criteria] must be above \"min_rise\"");
  const Thermometer& t = deck.sensor.thermometer;
  if ((t.resistance > 0.0) != (t.coefficient > 0.0))
    errors.add("sensor", "[sensor] has one of \"resistance\" and \"resistance_coefficient\"; both belong together");
  if (deck.synthetic.transient.insulation.thickness > 0.0 && is_layered(deck.synthetic.transient)) {
    errors.add(
        "synthetic.insulation",
        "[synthetic.insulation] adds to the sample's rise, [[synthetic.layer]] and [synthetic.heater] conduct and "
        "store heat with it; give one or the other");
  }
  deck.synthetic.transient.radius = deck.sensor.radius;
  deck.synthetic.transient.power = deck.evaluation.power;
}

}  // namespace

std::string tps_keys() {
  return key_reference<TpsDeck>("Keys of a file for repose thermal tps or repose thermal synthesise.");
}

TpsDeck read_tps_deck(const ToolInput& input) { return read_tool_deck<TpsDeck>(input, check); }

SourceFunction source_of(const SensorDeck& sensor) {
  return sensor.type == SourceType::disc ? SourceFunction::disc()
                                         : SourceFunction::of_rings(sensor.rings, sensor.cutoff);
}

}  // namespace repose::thermal
