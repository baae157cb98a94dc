"""The corner of the thesis's grid with the least sliding friction and the most rolling friction, at full size: is there a pile?"""

from bench import ROOT, STOPPED, measured, print_table, rayleigh_share, repose, save, time_limit

DECK = ROOT / "input" / "carbohsp_mono.toml"
CORNER = ["pair.0.sliding_friction=0.1", "pair.0.rolling_friction=0.5"]
# Name of the results and share of the Rayleigh time; with 0.4 a full bed does not rest (studies.py settling)
CASES = {"little_friction": 0.4, "little_friction_shorter_step": 0.3}


def study(options):
    """25 g of CarboHSP on all ranks, and the pile every half second; also of a run that is stopped by --time-limit."""
    for name in options.cases or CASES:
        grow(options, name, [*CORNER, *rayleigh_share(CASES[name])])


def grow(options, name, sets):
    """One of the runs, and the table of its pile."""
    try:
        repose.run(DECK, options.work / name, set=sets, ranks=options.ranks, program=options.program,
                   restart=True, options=time_limit(options))
    except repose.ReposeError as error:
        if error.code != STOPPED:
            raise SystemExit(f"{name}: {error}") from None
    run = repose.Run(options.work / name)
    rows = []
    for snapshot in run.snapshots[1::2]:
        summary = measured(options, snapshot.path, DECK, snapshot.path.parent / "measured" / snapshot.path.stem)
        rows.append({"time, s": round(snapshot.time_s, 2), "discharged, g": 1e3 * summary["discharged_mass_kg"],
                     "height, mm": 1e3 * summary["pile_height_m"], "angle, degrees": summary["angle_of_repose_deg"],
                     "error, degrees": summary["angle_of_repose_stderr_deg"]})
    print_table(rows, digits=4)
    save(options.results / f"{name}.json", set=sets, is_complete=run.is_complete, rows=rows)
