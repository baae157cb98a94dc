"""Beverloo's law: the rate of discharge goes as (D - k d)^2.5 with k = 1.4 over three orifices, within 10 %, and does not
depend on the fill height. Grains of CarboHSP in a cylinder of 7 mm radius, discharged for 0.3 s into the void.

Usage: beverloo_test.py EXECUTABLE MPIEXEC SOURCE_DIR
"""

import sys
import tempfile

from repose_runs import Program, read_series

D_GRAIN = 440e-6
K = 1.4
ORIFICES = (3.5e-3, 4.5e-3, 5.5e-3)


def case(program, folder, orifice, count):
    radius = orifice / 2
    return (program.deck("discharge_mini.toml"), f"{folder}/{orifice}_{count}", f"particles.0.count={count}",
            "wall.plate.present=false", f"wall.lid.radius={radius}", "particles.0.radius=7 mm", "particles.0.height=95 mm",
            "particles.0.spacing=800 um", f"wall.vessel.points=[[0.007,0.1],[0.007,0],[{radius},0]]", "domain.max=[0.03,0.03,0.1]",
            "phase.fill.time=0.2", "phase.discharge.time=0.3", "measurement.angle_of_repose.plate_height=-0.02")


def steady_rate(output):
    """kg/s between 0.1 s after the opening (at 0.2 s) and the end, while the vessel is still well filled."""
    rows = [row for row in read_series(output) if row["time_s"] >= 0.2999]
    return (rows[-1]["discharged_mass_kg"] - rows[0]["discharged_mass_kg"]) / (rows[-1]["time_s"] - rows[0]["time_s"])


def main():
    program = Program(*sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        runs = [case(program, folder, d, 20000) for d in ORIFICES] + [case(program, folder, ORIFICES[0], 14000)]
        program.run_all(runs)
        rates = [steady_rate(run[1]) for run in runs]
    scaled = [rate / (d - K * D_GRAIN) ** 2.5 for d, rate in zip(ORIFICES, rates)]
    fit = sum(scaled) / len(scaled)
    print("rates", rates, "kg/s; over (D - 1.4 d)^2.5:", [s / fit for s in scaled])
    print("C =", fit / (2115.0 * 9.81**0.5), "with the bulk density 2115 kg/m3; lower fill height:", rates[3] / rates[0])
    assert all(abs(s / fit - 1.0) < 0.10 for s in scaled)
    assert abs(rates[3] / rates[0] - 1.0) < 0.10


main()
