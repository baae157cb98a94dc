"""What reports of calibrations and of sensitivity studies have in common: the runs."""

import datetime

from repose.files import ReposeError
from repose.program import set_options
from repose.report import html, numbers, parts
from repose.units import words

MOST_BOXES = 200  # runs of which all figures are shown, and the pile if there is room
UNDECIDED = (" There is no result: a search may still be deciding on its next points, or too few runs have the "
             "figures; <code>repose estimate</code> says which.")
MARK = {"failed": "bad", "plugged": "bad", "waiting": "none", "running": "none"}


def bases_of(deck):
    """The experiments of a deck, as what stands before a name, and their base decks; one without a name when there are
    none."""
    return [(e["name"] + ": ", e.get("base", deck.get("base"))) for e in deck.get("experiment", [])] or [
        ("", deck["base"])]


def asked(deck):
    """Name and value of what the decks of all studies say."""
    bases = ", ".join(f"{html.escape(name)}<code>{html.escape(base)}</code>" for name, base in bases_of(deck))
    rows = [("base deck", bases),
            ("seeds at each point", html.escape(deck.get("seeds", 1)))]
    if deck.get("set"):
        rows.append(("changed for all runs", ", ".join(f"<code>{html.escape(item)}</code>" for item in deck["set"])))
    return rows


class Runs:
    """The runs of a study with their summaries, each read once."""

    def __init__(self, study, figures, order=()):
        """`order` has the rows that matter most, the first first."""
        self.study, self.figures, self.grid = study, figures, study.grid
        self.runs = [run if run is not None and run.is_complete else None for run in study.runs]
        self.folders = study.folders
        self.groups = [key for key in ("experiment", "level") if key in self.grid]
        rows = range(self.grid.rows)
        failed = [row for row in rows if self.grid["state"][row] == "failed"]
        weight = {row: place for place, row in enumerate([*order, *failed])}
        self.order = sorted(rows, key=lambda row: weight.get(row, self.grid.rows + row))
        self.boxed = set(self.order[:MOST_BOXES])

    def has_box(self, row):
        """Whether there is something to be shown of a run beyond its row; of a thousand not of all."""
        return row in self.boxed

    def name(self, row):
        """What a run is, in words."""
        parts_ = [f"{words(name)} {self.grid[name][row]:g}" for name in self.study.parameters]
        before = "".join(f"{self.grid[key][row]}, " for key in self.groups)
        return f"{before}{', '.join(parts_)}, seed {self.grid['seed'][row]:.0f}"

    def value(self, row, figure):
        """Value and standard error within the run; None where there is none."""
        run = self.runs[row]
        if run is None or not self.study.is_asked(row, figure):
            return None, None
        key = figure.removeprefix(self.study.before(row))
        try:
            return run.figure(key), run.error(key)
        except ReposeError:  # the score of a curve
            value = self.grid[figure][row] if figure in self.grid else float("nan")
            return (float(value), None) if value == value else (None, None)

    def text(self, row):
        """For the pointer: the run and its figures."""
        lines = [self.name(row), self.grid["state"][row]]
        for figure in self.figures:
            if not self.study.is_asked(row, figure):
                continue
            value, error = self.value(row, figure)
            name, unit, factor = numbers.display(figure)
            if value is not None:
                lines.append(f"{name} {numbers.with_error(factor * value, error and factor * error)} {unit}".strip())
            else:
                lines.append(f"{name}: none")
        return "\n".join(lines)

    def cells(self, row):
        state = self.grid["state"][row]
        cells = [numbers.data(str(row + 1), row + 1) if row not in self.boxed
                 else f'<a href="#run-{row}">{row + 1}</a>']
        cells += [html.escape(self.grid[key][row]) for key in self.groups]
        cells += [numbers.data(f"{self.grid[name][row]:g}", float(self.grid[name][row]))
                  for name in self.study.parameters]
        cells += [numbers.data(f"{self.grid['seed'][row]:.0f}", float(self.grid["seed"][row])),
                  html.element("span", html.escape(state), class_=MARK.get(state))]
        cells += [numbers.figure(figure, *self.value(row, figure), with_unit=False) for figure in self.figures]
        run = self.runs[row]
        seconds = run.summary["wall_seconds"] if run else None
        return cells + [numbers.data(numbers.plain(seconds, 3), seconds) if run else ""]

    def table(self):
        """All of them, to be sorted."""
        head = ["run", *self.groups, *map(words, self.study.parameters), "seed",
                "state",
                *(numbers.quantity(figure) for figure in self.figures), "wall time, s"]
        first = 1 + len(self.groups)
        numeric = [k for k in range(first, len(head)) if head[k] != "state"]
        return html.table([html.escape(h) for h in head], [self.cells(row) for row in range(self.grid.rows)],
                          "sortable", numeric)

    def boxes(self, pictures, shown=()):
        """A box for each run, which links open; those that matter most get their pictures first, those `shown` have
        them elsewhere."""
        content = {}
        for row in self.order[:MOST_BOXES]:
            run = self.runs[row]
            reason = self.grid["reason"][row]
            content[row] = html.paragraph(html.escape(reason), "bad") if reason else ""
            if run is None:
                content[row] += html.paragraph(f"{html.escape(self.grid['state'][row])}: there is nothing to show.",
                                               "none")
            else:
                content[row] += parts.figures_table(run)
                content[row] += above(row) if row in shown else pictures.of_run(run, ("silhouette",))
        return "".join(html.details(f"run {row + 1}: {html.escape(self.name(row))}", content[row], id_=f"run-{row}")
                       for row in sorted(self.boxed))


def state(study):
    """How far the runs are; empty when they are done and the result is there."""
    if not study.has_grid:
        return html.paragraph("Not one run is complete.")
    states = study.states
    open_runs = states["running"] + states["waiting"]
    if study.is_complete and not open_runs:
        return ""
    seconds = (study.directory / "grid.csv").stat().st_mtime
    written = datetime.datetime.fromtimestamp(seconds).strftime("%d %B %Y, %H:%M")
    total = sum(states.values())
    ended = total - open_runs
    counts = ", ".join(f"{count} {name}" for name, count in states.items() if count)
    text = f"Not complete: {ended} of {total} runs have ended ({counts}), as of {written}."
    if not study.is_complete:
        text += " There is no result yet." if open_runs else UNDECIDED
    return parts.progress_bar(ended / total if total else 0.0, text)


def above(row):
    return html.paragraph(f'<a href="#pile-{row}">Its pictures</a> are among those nearest the answer.')


def links(runs, rows, most=12):
    """To runs, by their numbers."""
    shown = ", ".join(f'<a href="#run-{row}">{row + 1}</a>' if runs.has_box(row) else str(row + 1)
                      for row in rows[:most])
    return shown + (f" and {len(rows) - most} more" if len(rows) > most else "")


def warnings(runs):
    """Runs that failed or plugged, and figures that runs do not have."""
    grid, found = runs.grid, []
    for row in range(grid.rows):
        if grid["state"][row] == "failed":
            found.append(f"Run {links(runs, [row])} failed: {html.escape(grid['reason'][row])}")
    plugged = [row for row in range(grid.rows) if grid["state"][row] == "plugged"]
    if plugged:
        found.append(f"{len(plugged)} of {grid.rows} runs plugged: {links(runs, plugged)}. They count for masses that are "
                     "not of flowing runs only, and for no other figure.")
    for figure in runs.figures:
        without = [row for row in range(grid.rows) if grid["state"][row] == "done"
                   and runs.study.is_asked(row, figure) and runs.value(row, figure)[0] is None]
        if without:
            found.append(f"No {numbers.name(figure)} in {len(without)} of the runs that are done: "
                         f"{links(runs, without)}.")
    return found


def repeat(study, runs, command, nearest):
    """Commands and decks; the deck of a run has all that the base deck said."""
    complete = [run for run in runs.runs if run]
    build = complete[0].summary["build"] if complete else {}
    ranks = max((run.summary["ranks"] for run in complete), default=1)
    seconds = sum(run.summary["wall_seconds"] * run.summary["ranks"] for run in complete)
    rows = [("processor time", f"{numbers.duration(seconds)} of all runs together"),
            ("ranks of a run", f"at most {ranks}")]
    name = study.directory.resolve().name
    commands = [parts.command_line("mpirun", "-n", max(2, ranks), "repose", command, study.deck_file, "--output", name,
                                   *set_options(study.overrides))]
    bases = " and ".join(base for _, base in bases_of(study.deck))
    decks = [(study.deck_file + f" (its base is {bases}, relative to where it was)", study.deck_text)]
    if nearest:
        run, folder = nearest
        rows.append(("hash of that run's state", f"<code>{run.summary['state_hash']}</code>"))
        commands.append(parts.command_line("repose", "run",
                                           f"{folder.relative_to(study.directory)}/deck.resolved.toml", "--output",
                                           "nearest"))
        decks.append(("the resolved deck of the run nearest the answer", run.deck_text))
    return parts.repeat(build, commands, decks, rows)
