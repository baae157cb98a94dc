#!/usr/bin/python3
"""What the ideal evaluation of a plane source makes of its insulation, beside the thesis's readings; see README.md."""

import json
import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, print_table, save, usual_options  # noqa: E402  (and where the package is)
from repose.files import ReposeError  # noqa: E402
from repose.program import call, set_options  # noqa: E402

DECK = ROOT / "input" / "thermal_tps_mica.toml"
READINGS = ROOT / "input" / "thermal_sensor.toml"  # Tables 5.1 to 5.3
# Conductivity, volumetric heat, duration with the 9 mm sensor (0.53 of the characteristic time), power with it.
SAMPLES = {
    "stainless": (13.55, 470.0 * 7900.0, 11.7, 4.0),   # literature, Table 5.1
    "carbohsp": (0.21, 734.46 * 2115.0, 320.0, 0.09),  # literature, Table 5.2
    "sand": (0.32, 459.33 * 1526.0, 94.0, 0.14),       # kapton of 9 mm, Table 5.3
}
# Thickness, conductivities through and along, volumetric heat of the sheet on each side.
LAYER = ("thickness", "conductivity", "radial_conductivity", "volumetric_heat")
KAPTON = (25e-6, 0.12, 0.12, 1420.0 * 1090.0)
MICA = (120e-6, 0.46, 4.0, 2830.0 * 819.0)


def thesis():
    """{(material, insulation, radius in mm): (conductivity, specific heat)} of the thesis's readings."""
    with open(READINGS, "rb") as file:
        materials = tomllib.load(file)["material"]

    def number(text):
        return float(text.split()[0])

    return {(m["name"], room["insulation"], number(room["radius"])): (number(room["conductivity"]),
                                                                      number(room["specific_heat"]))
            for m in materials for room in m["room"]}


class Instrument:
    """Makes transients up and evaluates them, with the program."""

    def __init__(self, options):
        self.program, self.work = options.program, options.work

    def read(self, sample, layer, radius_mm=9.0, **changes):
        """(conductivity, volumetric heat) over those of the sample (as in SAMPLES), and the root mean square of the
        residuals in K. Times go with the square of the radius, powers with the radius: all is alike but the layer."""
        k, heat, duration, power = sample
        scale = radius_mm / 9.0
        values = {"sensor.radius": 1e-3 * radius_mm, "evaluation.power": power * scale, "synthetic.conductivity": k,
                  "synthetic.volumetric_heat": heat, "synthetic.duration": duration * scale**2, "synthetic.noise": 0,
                  **{f"synthetic.layer.0.{key}": value for key, value in zip(LAYER, layer)}, **changes}
        sets = set_options(values)
        self.call("synthesise", DECK, *sets)
        self.call("tps", self.work / "transient.csv", "--deck", DECK, *sets)
        result = json.loads((self.work / "tps.json").read_text())["transients"][0]
        return (result["conductivity_W_mK"]["value"] / k, result["volumetric_heat_J_m3K"]["value"] / heat,
                result["mean_deviation_K"])

    def call(self, tool, *words):
        call(["thermal", tool, *words, "--output", self.work], program=self.program)


def percent(ratio):
    return f"{100.0 * (ratio - 1.0):+.1f}"


def readings(instrument):
    """Mica against kapton, here and in the thesis."""
    rows, read = [], thesis()
    for name, sample in SAMPLES.items():
        for radius in (6.5, 9.0):
            mica, kapton = (instrument.read(sample, layer, radius) for layer in (MICA, KAPTON))
            k, heat = (a / b for a, b in zip(read[name, "mica", radius], read[name, "kapton", radius]))
            rows.append({"sample": name, "radius, mm": f"{radius:g}", "kapton k, %": percent(kapton[0]),
                         "mica k, %": percent(mica[0]), "mica over kapton k, %": percent(mica[0] / kapton[0]),
                         "thesis k, %": percent(k), "mica over kapton heat, %": percent(mica[1] / kapton[1]),
                         "thesis heat, %": percent(heat), "residual, mK": f"{1e3 * mica[2]:.2g}"})
    return rows


def sheets(instrument):
    """CarboHSP with mica of several conductivities along the sheet."""
    rows = []
    for along in (1e-6, 0.46, 1.0, 2.0, 4.0, 5.0):
        row = {"along the sheet, W/(m K)": f"{along:g}"}
        for radius in (6.5, 9.0):
            k, heat, _ = instrument.read(SAMPLES["carbohsp"], (*MICA[:2], along, MICA[3]), radius)
            row |= {f"k, {radius:g} mm, %": percent(k), f"heat, {radius:g} mm, %": percent(heat)}
        rows.append(row)
    return rows


def conductivities(instrument):
    """Mica of 9 mm on samples that conduct better than CarboHSP, and store and are measured alike."""
    k0, heat, duration, power = SAMPLES["carbohsp"]
    rows = []
    for k in (0.21, 0.32, 0.45, 0.8, 1.45, 3.0, 13.55):
        found, _, _ = instrument.read((k, heat, duration * k0 / k, power * k / k0), MICA)
        rows.append({"k, W/(m K)": f"{k:g}", "k, %": percent(found), "added, W/(m K)": f"{(found - 1.0) * k:+.3f}"})
    return rows


def choices(instrument):
    """What else is assumed, on CarboHSP with the 9 mm sensor."""
    cases = {"as above": {}, "80 s": {"synthetic.duration": 80}, "160 s": {"synthetic.duration": 160},
             "640 s": {"synthetic.duration": 640}, "50 points left out": {"evaluation.leave_out_first": 50},
             "100 points left out": {"evaluation.leave_out_first": 100},
             "20 um of nickel": {"synthetic.heater.thickness": 20e-6}, "30 rings": {"sensor.rings": 30},
             "sheet stores nothing": {"synthetic.layer.0.volumetric_heat": 1.0}}
    rows = []
    for name, changes in cases.items():
        k, heat, residual = instrument.read(SAMPLES["carbohsp"], MICA, **changes)
        rows.append({"choice": name, "k, %": percent(k), "heat, %": percent(heat),
                     "residual, mK": f"{1e3 * residual:.2g}"})
    return rows


def main():
    parser = usual_options(__doc__, "plane_source")
    options = parser.parse_args()
    instrument = Instrument(options)
    try:
        tables = {study.__name__: study(instrument) for study in (readings, sheets, conductivities, choices)}
    except ReposeError as error:
        raise SystemExit(str(error)) from None
    for rows in tables.values():
        print_table(rows)
        print()
    save(options.results / "insulation.json", **tables)


if __name__ == "__main__":
    main()
