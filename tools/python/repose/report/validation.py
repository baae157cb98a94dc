"""The report of a validation."""

import math

from repose import plots
from repose.report import html, numbers, parts, svg
from repose.report.page import Report, Section


NOTHING = '<span class="none">-</span>'


def deviations(comparison):
    """By how many standard deviations, of the laboratory and of this run together, a figure is off; None without
    one."""
    here, error, deviation = comparison["here"], comparison["error"], comparison["deviation"]
    if here is None or deviation is None:
        return None
    total = math.hypot(deviation, error or 0.0)
    return (here - comparison["laboratory"]) / total if total > 0.0 else None


def share(value, comparison):
    """Difference from the laboratory, in per cent of it."""
    if value is None or comparison["laboratory"] == 0.0:
        return NOTHING
    percent = 100.0 * (value / comparison["laboratory"] - 1.0)
    return numbers.data(f"{percent:+.1f} %", percent)


def cells(name, comparison):
    figure, off = comparison["figure"], deviations(comparison)
    return [html.escape(name), html.escape(numbers.quantity(figure)),
            numbers.figure(figure, comparison["here"], comparison["error"], with_unit=False),
            numbers.figure(figure, comparison["laboratory"], comparison["deviation"], with_unit=False),
            share(comparison["here"], comparison), NOTHING if off is None else numbers.signed(off, 1),
            numbers.figure(figure, comparison["published"], with_unit=False),
            share(comparison["published"], comparison)]


def comparisons(found):
    return [(name, comparison) for name, listed in found.cases.items() for comparison in listed]


def answer(found):
    if not found.is_complete:
        return html.paragraph("The comparison is made when all cases are complete.")
    all_of_them = comparisons(found)
    off = [abs(d) for _, c in all_of_them if (d := deviations(c)) is not None]
    within = sum(d <= 2.0 for d in off)
    without = sum(c["here"] is None for _, c in all_of_them)
    agreement = (f"{within} of {len(off)} figures are within two standard deviations of the laboratory" if off else
                 "The laboratory's deviations are not known")
    text = html.paragraph(agreement, "large")
    if without:
        text += html.paragraph(f"{without} of {len(all_of_them)} figures have no value here.")
    head = ["case", "figure", "here", "laboratory", "difference", "off by, σ",
            html.escape(found.result["published"] or "published"), "difference"]
    return text + html.table(head, [cells(*c) for c in all_of_them], "sortable", numeric=range(2, 8)) + html.paragraph(
        "± of the laboratory is its standard deviation, ± here the standard error within the run; σ is both together.",
        "none")


def warnings(found):
    listed = []
    for name, run in found.runs.items():
        if run.is_complete:
            listed += [f"{html.escape(name)}: {text}" for text in parts.run_warnings(run)]
    if found.is_complete:
        for name, c in comparisons(found):
            if c["here"] is None and not c["figure"].startswith("angle_of_repose"):  # which the run's warnings explain
                listed.append(f"{html.escape(name)} has no {numbers.name(c['figure'])}.")
    return listed


def differences(found):
    """A picture of all figures over the laboratory's, with its deviations."""
    from repose.plots.style import WIDTH, new_figure
    if not found.is_complete:
        return ""
    shown = [(name, c) for name, c in comparisons(found) if c["here"] is not None and c["laboratory"]]
    if not shown:
        return ""
    figure, axes = new_figure(figsize=(WIDTH, 1.0 + 0.5 * len(shown)))
    published = found.result["published"] or "published"
    first_published = next((place for place, (_, c) in enumerate(shown) if c["published"] is not None), None)
    for place, (name, c) in enumerate(shown):
        over = 100.0 / abs(c["laboratory"])
        here, error = (c["here"] - c["laboratory"]) * over, (c["error"] or 0.0) * over
        axes.barh(place, 2.0 * (c["deviation"] or 0.0) * over, left=-(c["deviation"] or 0.0) * over, color="0.85",
                  height=0.35,
                  label=None if place else "laboratory ± deviation")
        axes.errorbar(here, place, xerr=error, fmt="o", color="tab:blue", capsize=3,
                      label=None if place else "here ± standard error")
        if c["published"] is not None:
            axes.plot((c["published"] - c["laboratory"]) * over, place, "D", color="tab:orange", markersize=4,
                      label=published if place == first_published else None)
        axes.text(0.01, place - 0.36, f"{name}: {numbers.display(c['figure'])[0]}", fontsize=8,
                  transform=axes.get_yaxis_transform())
    axes.axvline(0.0, color="black", linewidth=0.8)
    axes.set(yticks=[], ylim=(len(shown) - 0.5, -0.75), xlabel="difference from the laboratory, %")
    axes.legend(fontsize=7, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, frameon=False)
    return html.picture(svg.of_figure(figure, "differences from the laboratory"))


def case_html(name, run, pictures):
    """One case: how far it is, its figures, pictures and course."""
    text = html.element("h3", html.escape(name))
    if not run.is_complete:
        return text + parts.run_state(run)
    return (text + pictures.of_run(run) + parts.course(run, plots) +
            html.details("all figures", parts.figures_table(run), id_=f"case-{name}"))


def state(found):
    if found.is_complete:
        if not found.not_compared:
            return ""
        return html.paragraph(f"The comparison is that of an earlier call; not in it are {', '.join(map(html.escape, found.not_compared))}, "
                              "which have begun since.")
    runs = found.runs
    done = sum(run.is_complete for run in runs.values())
    return html.paragraph(f"Not complete: {done} of {len(runs)} cases that have begun are done. There is no comparison "
                          "yet.")


def repeat(found):
    runs = {name: run for name, run in found.runs.items() if run.is_complete}
    build = found.result["build"] if found.is_complete else next((run.summary["build"] for run in runs.values()), {})
    rows = [(f"hash of {html.escape(name)}",
             f"<code>{run.summary['state_hash']}</code>, {numbers.duration(run.summary['wall_seconds'])} on "
             f"{run.summary['ranks']} ranks") for name, run in runs.items()]
    commands = [parts.command_line("repose", "run", f"{name}/deck.resolved.toml", "--output", f"again/{name}")
                for name in found.runs]
    return parts.repeat(build, commands, [(f"{name}/deck.resolved.toml", run.deck_text)
                                          for name, run in found.runs.items()], rows)


def report(found):
    """The `Report` of a `Validation`."""
    pictures = parts.Pictures()
    cases = "".join(case_html(name, run, pictures) for name, run in found.runs.items())
    sections = [Section("differences", "Differences from the laboratory", differences(found)),
                Section("cases", "Cases", cases), repeat(found)]
    return Report("validation", found.title, answer(found), state(found), warnings(found), sections)
