"""The corner of the thesis's grid with the least sliding friction and the most rolling friction, at full size: is there a pile?"""

import numpy as np

from bench import ROOT, identities, places, print_table, repose, save, time_limit

FRICTION = {"pair.0.sliding_friction": 0.1, "pair.0.rolling_friction": 0.5}
LONG_STEPS = {"time.rayleigh_fraction": 0.4, "time.hertz_fraction": 0.2}  # which change nothing: studies.py time_step
RINGS = (0, 5, 10, 15, 20, 25, 30, 40, 50, 70)  # mm from the axis


def study(options):
    """25 g of CarboHSP on all ranks; how high the grains lie on the plate, ring by ring."""
    name = "little_friction"
    try:
        run = repose.run(ROOT / "input" / "carbohsp_mono.toml", options.work / name, set=FRICTION | LONG_STEPS, ranks=options.ranks,
                         program=options.program, restart=True, options=time_limit(options))
    except repose.ReposeError as error:
        raise SystemExit(f"{name}: {error}") from None
    last, summary = run.snapshots[-1], run.summary
    from_axis, above = places(last)
    plate = run.deck["measurement"]["angle_of_repose"]["plate_height"]
    rows = []
    for low, high in zip(RINGS, RINGS[1:]):
        here = ~above & (1e3 * from_axis >= low) & (1e3 * from_axis < high)
        tops = 1e3 * (last.position[here, 2] + last.radius[here] - plate)
        rows.append({"ring, mm": f"{low} to {high}", "grains": int(np.count_nonzero(here)),
                     "highest, mm": float(tops.max()) if len(tops) else None})
    print_table(rows, digits=3)
    save(options.results / f"{name}.json", set=FRICTION | LONG_STEPS, rings=rows, runs=identities({name: summary}),
         figures={key: summary[key] for key in ("discharged_mass_kg", "angle_of_repose_deg", "pile_height_m",
                                                "discharge_time_s", "discharge_rate_kg_s")})
