"""Sections that several kinds of reports have."""

import os
import pathlib
import platform
import shlex

from repose.report import html, numbers, svg
from repose.report.page import Section

PICTURE_NAMES = {"silhouette": "silhouette", "top_view": "top view"}
MOST_PICTURES = 3_000_000  # characters of all pictures that the program has made, of a page of at most 5 MB


class Pictures:
    """The program's own pictures, as many as there is room for; those asked for first come first."""

    def __init__(self):
        self.room = MOST_PICTURES

    def of_run(self, run, names=("silhouette", "top_view"), caption=""):
        """HTML of the pictures of a run, or where they are when there is no room."""
        found = []
        for name in names:
            path = run.picture(name)
            if path is None:
                continue
            shown = svg.of_file(path, PICTURE_NAMES[name])
            if len(shown) > self.room:
                found.append(html.paragraph(f"The {PICTURE_NAMES[name]} would make this file too large; it is "
                                            f"<code>{html.escape(path)}</code>.", "none"))
                continue
            self.room -= len(shown)
            found.append(html.picture(shown, html.escape(caption or PICTURE_NAMES[name])))
        return html.element("div", "".join(found), class_="pile") if found else ""


def figures_table(run, names=None):
    """The figures of a run that have a value, by name."""
    names = names or [name for name, value in run.figures.items()
                      if value is not None and "stderr" not in name and not name.endswith(".error")]
    rows = [[numbers.name(name), numbers.figure(name, run.figure(name), run.error(name)),
             f"<code>{html.escape(name)}</code>"] for name in names]
    return html.table(["figure", "value", "key"], rows, "sortable", numeric=(1,))


def course(run, plots):
    """Time series of a run."""
    drawn = ((plots.discharge, "discharged mass and its rate"), (plots.energies, "energies"),
             (plots.walls, "forces on the walls"), (plots.heat, "temperatures and heat from the walls"))
    return html.gallery([html.picture(shown, html.escape(caption)) for draw, caption in drawn
                         if (shown := svg.of_figure(draw(run), caption))])


def machine():
    """Where the report is made: files of runs do not say where they ran."""
    names = set()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                names.add(line.split(":", 1)[1].strip())
    except OSError:
        names.add(platform.processor() or platform.machine())
    processor = ", ".join(sorted(names)) or platform.machine()
    return f"{processor}, {os.cpu_count()} cores, {platform.system()} {platform.release()}"


def build_rows(build):
    """Version, commit and so on of the program that did the runs."""
    return [(html.escape(name.replace("_", " ")), f"<code>{html.escape(value)}</code>")
            for name, value in build.items()]


def command_line(*words):
    return shlex.join(str(word) for word in words)


def repeat(build, commands, decks, rows=()):
    """All that is needed to do it again: `decks` are pairs of a title and a text."""
    shown = html.pairs([*build_rows(build), *rows, ("machine of this report", html.escape(machine()))])
    shown += html.element("h3", "Commands") + html.code("\n".join(commands))
    for title, text in decks:
        shown += html.details(html.escape(title), html.code(text), is_open=True)
    return Section("repeat", "To repeat it", shown)


def progress_bar(share, text):
    bar = html.element("progress", "", value=f"{min(max(share, 0.0), 1.0):.3f}", max="1") if share is not None else ""
    return html.paragraph(text) + bar


def run_state(run):
    """How far a run is that is not complete."""
    progress = run.progress
    text = f"Not complete: {progress['time_s']:.4g} s are simulated, in phase {html.escape(progress['phase'])}"
    most = progress["most_time_s"]
    if most:
        text += f", of at most {most:.4g} s"
    return progress_bar(progress["time_s"] / most if most else None, text + ".")


def run_warnings(run):
    """What a person has to know of a complete run."""
    summary, found = run.summary, []
    if summary.get("plugged"):
        found.append("The orifice has plugged: the discharge came to an end with most grains above it. There is no "
                     "angle of repose.")
    for phase, deck in zip(summary["phases"], run.deck["phase"]):
        if phase["ended_by"] == "max_time" and deck.get("until") not in ("time", "steps"):
            found.append(f"Phase {html.escape(phase['name'])} was ended by its max_time, not by its condition "
                         f"({html.escape(deck['until'])}).")
    is_asked = "angle_of_repose" in run.deck.get("measurement", {})
    if is_asked and summary.get("angle_of_repose_deg") is None and not summary.get("plugged"):
        found.append("The angle of repose was asked for, but there is no pile to measure.")
    if summary.get("restarts"):
        found.append(f"The run was interrupted and went on {summary['restarts']} times; its state does not depend on "
                     "that.")
    return found
