#!/usr/bin/python3
"""What the ideal evaluation of a plane source makes of its insulation, beside the thesis's Tables 5.1 to 5.3; see README.md."""

import argparse
import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from report import ROOT, print_table, save  # noqa: E402

DECK = ROOT / "input" / "thermal_tps_mica.toml"
# Conductivity, volumetric heat, duration with the 9 mm sensor (0.53 of the characteristic time), power with it.
SAMPLES = {
    "CarboHSP": (0.21, 734.46 * 2115.0, 320.0, 0.09),  # literature, Table 5.2
    "sand": (0.32, 459.33 * 1526.0, 94.0, 0.14),       # kapton of 9 mm, Table 5.3
    "steel": (13.55, 470.0 * 7900.0, 11.7, 4.0),       # literature, Table 5.1
}
# Thickness, conductivities through and along, volumetric heat of the sheet on each side; the metal between is 10 um.
KAPTON = (25e-6, 0.12, 0.12, 1420.0 * 1090.0)
MICA = (120e-6, 0.46, 4.0, 2830.0 * 819.0)
READ = {  # specific heat, conductivity in the thesis by sample, insulation and radius in mm
    "steel": {"kapton": {6.5: (437.42, 13.19), 9.0: (459.78, 13.60)}, "mica": {6.5: (455.65, 13.65), 9.0: (419.20, 13.28)}},
    "CarboHSP": {"kapton": {6.5: (813.95, 0.24), 9.0: (751.55, 0.21)}, "mica": {6.5: (888.67, 0.31), 9.0: (863.99, 0.30)}},
    "sand": {"kapton": {6.5: (382.87, 0.31), 9.0: (459.33, 0.32)}, "mica": {6.5: (533.34, 0.40), 9.0: (478.51, 0.41)}},
}


class Instrument:
    """Makes transients up and evaluates them, with the program."""

    def __init__(self, options):
        self.program, self.work = options.program, options.work

    def read(self, sample, layer, radius_mm=9.0, **changes):
        """(conductivity, volumetric heat) over those of the sample, less 1, and the root mean square of the residuals in K.
        sample: as in SAMPLES. Times go with the square of the radius, powers with the radius: all is alike but for the layer."""
        k, heat, duration, power = sample
        scale = radius_mm / 9.0
        names = ("thickness", "conductivity", "radial_conductivity", "volumetric_heat")
        values = {"sensor.radius": 1e-3 * radius_mm, "evaluation.power": power * scale, "synthetic.conductivity": k,
                  "synthetic.volumetric_heat": heat, "synthetic.duration": duration * scale**2, "synthetic.noise": 0,
                  **{f"synthetic.layer.0.{name}": value for name, value in zip(names, layer)}, **changes}
        sets = ["--set", *(f"{key}={value}" for key, value in values.items())]
        self.call("synthesise", DECK, *sets)
        self.call("tps", self.work / "transient.csv", "--deck", DECK, *sets)
        result = json.loads((self.work / "tps.json").read_text())["transients"][0]
        return (result["conductivity_W_mK"]["value"] / k - 1.0, result["volumetric_heat_J_m3K"]["value"] / heat - 1.0,
                result["mean_deviation_K"])

    def call(self, tool, *words):
        done = subprocess.run([self.program, "thermal", tool, *map(str, words), "--output", str(self.work)], capture_output=True,
                              text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr.strip())


def percent(ratio):
    return f"{100.0 * ratio:+.1f}"


def sheets(instrument):
    """CarboHSP with mica of several conductivities along the sheet, and with parts of the sheet left out."""
    cases = {f"{along:g}": (*MICA[:2], along, MICA[3]) for along in (1e-6, 0.46, 1.0, 2.0, 4.0, 5.0)}
    rows = []
    for name, layer in cases.items():
        row = {"along the sheet, W/(m K)": name}
        for radius in (6.5, 9.0):
            k, heat, _ = instrument.read(SAMPLES["CarboHSP"], layer, radius)
            row |= {f"k, {radius:g} mm, %": percent(k), f"heat, {radius:g} mm, %": percent(heat)}
        rows.append(row)
    return rows


def readings(instrument):
    """Mica against kapton, here and in the thesis."""
    rows = []
    for sample, read in READ.items():
        for radius in (6.5, 9.0):
            mica, kapton = (instrument.read(SAMPLES[sample], layer, radius) for layer in (MICA, KAPTON))
            heat, k = (read["mica"][radius][i] / read["kapton"][radius][i] - 1.0 for i in (0, 1))
            rows.append({"sample": sample, "radius, mm": f"{radius:g}", "kapton k, %": percent(kapton[0]),
                         "mica k, %": percent(mica[0]), "mica over kapton k, %": percent((1 + mica[0]) / (1 + kapton[0]) - 1),
                         "thesis k, %": percent(k), "mica over kapton heat, %": percent((1 + mica[1]) / (1 + kapton[1]) - 1),
                         "thesis heat, %": percent(heat), "residual, mK": f"{1e3 * mica[2]:.2g}"})
    return rows


def conductivities(instrument):
    """Mica of 9 mm on samples that conduct better than CarboHSP, and store and are measured alike."""
    k0, heat, duration, power = SAMPLES["CarboHSP"]
    rows = []
    for k in (0.21, 0.32, 0.45, 0.8, 1.45, 3.0, 13.55):
        found, _, _ = instrument.read((k, heat, duration * k0 / k, power * k / k0), MICA)
        rows.append({"k, W/(m K)": f"{k:g}", "k, %": percent(found), "added, W/(m K)": f"{found * k:+.3f}"})
    return rows


def choices(instrument):
    """What else is assumed, on CarboHSP with the 9 mm sensor."""
    cases = {"as above": {}, "80 s": {"synthetic.duration": 80}, "160 s": {"synthetic.duration": 160},
             "640 s": {"synthetic.duration": 640}, "50 points left out": {"evaluation.leave_out_first": 50},
             "100 points left out": {"evaluation.leave_out_first": 100}, "20 um of nickel": {"synthetic.heater.thickness": 20e-6},
             "30 rings": {"sensor.rings": 30}, "sheet stores nothing": {"synthetic.layer.0.volumetric_heat": 1.0}}
    rows = []
    for name, changes in cases.items():
        k, heat, residual = instrument.read(SAMPLES["CarboHSP"], MICA, **changes)
        rows.append({"choice": name, "k, %": percent(k), "heat, %": percent(heat), "residual, mK": f"{1e3 * residual:.2g}"})
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default=os.environ.get("REPOSE", str(ROOT / "build" / "release" / "src" / "repose")),
                        help="the program (default: $REPOSE or build/release/src/repose)")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "benchmarks" / "plane_source", help="a folder")
    parser.add_argument("--results", type=pathlib.Path, default=ROOT / "benchmarks" / "results" / "plane_source",
                        help="where insulation.json goes")
    options = parser.parse_args()
    instrument = Instrument(options)
    tables = {study.__name__: study(instrument) for study in (readings, sheets, conductivities, choices)}
    for rows in tables.values():
        print_table(rows)
        print()
    save(options.results / "insulation.json", **tables)


if __name__ == "__main__":
    main()
