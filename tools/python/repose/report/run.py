"""The report of a run."""

import repose.plots as plots
from repose.report import html, numbers, parts
from repose.report.page import Report, Section

FIRST = ("angle_of_repose_deg", "discharged_mass_kg", "discharge_rate_kg_s", "surface_angle_deg", "tilt_onset_deg",
         "static_angle_of_repose_deg", "flow_energy_J", "retained_slope_deg", "bulk_density_kg_m3", "porosity",
         "scattering.area_1.count")


def answer(run):
    """The first figures that were measured, with their standard errors."""
    if not run.is_complete:
        return html.paragraph("There are no figures before the end of the run.")
    names = [name for name in FIRST if name in run.figures and run.figures[name] is not None][:4]
    if not names:
        return html.paragraph(f"Done: {numbers.plain(run.summary['time_s'])} s simulated; nothing was measured.",
                              "large")
    lines = [html.line(numbers.display(name)[0], numbers.figure(name, run.figure(name), run.error(name)))
             for name in names]
    note = "± is the standard error within this run; what differs from seed to seed is not in it."
    return "".join(lines) + (html.paragraph(note, "none") if any(run.error(name) is not None for name in names) else "")


def phases(run):
    rows = [[html.escape(phase["name"]), numbers.count(phase["steps"]), html.escape(phase["ended_by"])]
            for phase in run.summary["phases"]]
    return html.table(["phase", "steps", "ended by"], rows, numeric=(1,))


def asked(run):
    """What the deck describes."""
    deck = run.deck
    materials = ", ".join(html.escape(material["name"]) for material in deck.get("material", ()))
    walls = ", ".join(html.escape(wall["name"]) for wall in deck.get("wall", ()))
    rows = [("materials", materials), ("walls", walls or "none"),
            ("phases", ", ".join(html.escape(phase["name"]) for phase in deck.get("phase", ()))),
            ("measured", ", ".join(numbers.name(name) for name in deck.get("measurement", {})) or "nothing"),
            ("seed", html.escape(deck.get("run", {}).get("seed", 1)))]
    if run.is_complete:
        summary = run.summary
        grains, step = summary["particles"], summary["timestep_s"]
        exits = ", ".join(f"{count} by {html.escape(name)}" for name, count in grains["exits"].items() if count)
        rows += [("particles", f"{numbers.count(grains['inserted'])} inserted, {grains['inside']} inside, "
                  f"{grains['left']} left" + (f" ({exits})" if exits else "")),
                 ("simulated", f"{numbers.number('time_s', summary['time_s'])} s in {summary['steps']} steps of "
                  f"{numbers.number('timestep_s', step)} s, set by {html.escape(summary['timestep_set_by'])}")]
    return html.pairs(rows) + (phases(run) if run.is_complete else "")


def cost(run):
    summary = run.summary
    speed = numbers.plain(1e-6 * summary["particle_steps_per_second"], 3)
    stages = [[html.escape(name), numbers.data(f"{stage['mean_s']:.3g}", stage["mean_s"])]
              for name, stage in summary["timing"]["stages"].items() if stage["mean_s"] is not None]
    return html.pairs([("wall time", f"{numbers.duration(summary['wall_seconds'])} on {summary['ranks']} ranks"),
                       ("speed", f"{speed} million particle-steps per second"),
                       ("restarts", str(summary["restarts"]))]) + html.table(["stage", "mean over the ranks, s"],
                                                                             stages,
                                                                            "sortable", numeric=(1,))


def repeat(run):
    """Commands that do the run again, with its deck."""
    ranks, rows = 1, []
    if run.is_complete:
        ranks = run.summary["ranks"]
        rows = [("hash of the state", f"<code>{run.summary['state_hash']}</code>"), ("ranks", str(ranks))]
    launcher = ["mpirun", "-n", ranks] if ranks > 1 else []
    commands = [parts.command_line(*launcher, "repose", "run", "deck.resolved.toml", "--output",
                                   run.directory.resolve().name)]
    return parts.repeat(run.build, commands, [("deck.resolved.toml", run.deck_text)], rows)


def report(run):
    """The `Report` of a `Run`."""
    done = run.is_complete
    sections = [Section("asked", "What was asked", asked(run)),
                Section("figures", "Figures", parts.figures_table(run) if done else ""),
                Section("pictures", "Pictures", parts.Pictures().of_run(run)),
                Section("course", "Course of the run", parts.course(run, plots)),
                Section("cost", "Cost", cost(run) if done else ""), repeat(run)]
    state, warnings = ("", parts.run_warnings(run)) if done else (parts.run_state(run), [])
    return Report("run", run.title, answer(run), state, warnings, sections)
