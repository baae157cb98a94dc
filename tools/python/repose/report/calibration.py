"""The report of a calibration."""

from repose import plots
from repose.report import html, numbers, parts, study, svg
from repose.report.page import Report, Section
from repose.units import words

SHOWN = 3  # runs nearest the answer whose pictures are open


def interval_text(interval, error):
    below, above = ("below " if interval["open_below"] else ""), ("above " if interval["open_above"] else "")
    lower, upper = (numbers.beside(end, interval[end], error) for end in ("lower", "upper"))
    return f"{below}{lower} to {above}{upper}"


def point_lines(estimate, point):
    """Each calibrated parameter with its standard error and region."""
    what = "interval" if "posterior" in estimate else "region"
    share = f"{100 * estimate['confidence']:.0f} % {what}"
    intervals = estimate["parts"][point["part"]]["intervals"]
    return "".join(html.line(words(p["name"]), f"{numbers.number(p['name'], value, error)} "
                             f"<small>{share} {interval_text(interval, error)}</small>")
                   for p, value, error, interval in zip(estimate["parameters"], point["values"],
                                                        point["standard_errors"], intervals))


def region_lines(estimate, part):
    """Each calibrated parameter with a part of the region."""
    share = f"{100 * estimate['confidence']:.0f} % region"
    return "".join(html.line(words(p["name"]), f"<small>{share} "
                             f"{interval_text(interval, interval['upper'] - interval['lower'])}</small>")
                   for p, interval in zip(estimate["parameters"], estimate["parts"][part]["intervals"]))


def nearest_lines(estimate):
    """The nearest point, with the part of the region that it is in if it is acceptable: the first."""
    values = zip(estimate["parameters"], estimate["nearest"]["values"])
    lines = "".join(html.line(words(p["name"]), numbers.number(p["name"], value) + " <small>nearest point</small>")
                    for p, value in values)
    return lines + (region_lines(estimate, 0) if estimate["parts"] else "")


def other_part_lines(estimate):
    """The parts of the region in which there is no point."""
    known = {point["part"] for point in estimate["points"]} or {0}
    return "".join(html.element("h3", "Part of the region without such a point") + region_lines(estimate, part)
                   for part in range(len(estimate["parts"])) if part not in known)


def answer(found):
    if not found.is_complete:
        return html.paragraph("There is no estimate yet.")
    estimate = found.estimate
    points = estimate["points"]
    lines = html.paragraph(html.escape(estimate["verdict"][:1].upper() + estimate["verdict"][1:]) + ".")
    for number, point in enumerate(points):
        lines += html.element("h3", f"Crossing {number + 1}") if len(points) > 1 else ""
        lines += point_lines(estimate, point)
    if not points:
        lines += nearest_lines(estimate)
    return lines + other_part_lines(estimate)


def posterior_warnings(estimate):
    """Which parameters the figures do not tell of, and which they draw away from their priors."""
    listed = []
    for p, marginal in zip(estimate["parameters"], estimate.get("posterior", {}).get("marginals", ())):
        name = html.escape(words(p["name"]))
        if not marginal["determined"]:
            listed.append(f"The figures do not determine {name}: its posterior is as wide as its prior.")
            continue
        if marginal.get("separate"):
            listed.append(f"{name} may lie in separate ranges, with nothing between them.")
        if marginal["off_prior"] is not None and abs(marginal["off_prior"]) > 2.0:
            listed.append(f"{name} is off its prior by {numbers.signed(marginal['off_prior'])} standard deviations.")
    return listed


def overdue_text(phase):
    """Of how many runs a phase did not come to what it waited for."""
    of = " of ".join(phase[key] for key in ("level", "experiment") if key in phase)
    return html.escape(f"Phase {phase['phase']} was ended by its max_time, not by its condition, in {phase['runs']} of "
                       f"{phase['of']} runs{' of ' + of if of else ''}: a bed that is not at rest may lie denser.")


def warnings(found, runs):
    listed = []
    if found.is_complete:
        estimate = found.estimate
        if not estimate["points"]:
            fits = "is acceptable" if estimate["nearest"]["acceptable"] else "is not acceptable, either"
            listed.append(f"The laboratory's contour lines do not cross within the ranges; the nearest point {fits}.")
        if len(estimate["points"]) > 1:
            listed.append(f"There are {len(estimate['points'])} crossings: another observable would tell which is the "
                          "true one.")
        names = [p["name"] for p in estimate["parameters"]]
        open_ends = sorted({words(name) for part in estimate["parts"]
                            for name, interval in zip(names, part["intervals"])
                            if interval["open_below"] or interval["open_above"]})
        if open_ends:
            listed.append("The region is open: it meets the end of the range of "
                          f"{html.escape(', '.join(open_ends))} and may go on beyond.")
        listed += posterior_warnings(estimate)
        listed += [overdue_text(phase) for phase in estimate.get("ended_by_max_time", ())]
        for o in estimate["observables"]:
            if o["nearest_off_by"] is not None and abs(o["nearest_off_by"]) > 2.0:
                listed.append(f"{numbers.name(o['figure'])} is off by "
                              f"{numbers.signed(o['nearest_off_by'])} standard deviations.")
    return listed + (study.warnings(runs) if runs else [])


def asked(found):
    deck = found.deck
    rows = study.asked(deck)
    if "adaptive" in deck:
        rows.append(("search", html.escape(", ".join(f"{key} = {value}" for key, value in deck["adaptive"].items()))))
    ranges = [[html.word(p["name"]), f"<code>{html.escape(p['key'])}</code>",
               html.escape(p.get("values", f"{p.get('min')} to {p.get('max')}"))] for p in deck["parameter"]]
    return html.pairs(rows) + html.table(["parameter", "key", "values or range"], ranges) + laboratory(found)


def as_written(figure, value):
    """A number of a deck, or its text with a unit."""
    return numbers.figure(figure, value) if isinstance(value, (int, float)) else html.escape(value)


def laboratory(found):
    """What the laboratory has found, and what the runs say of it."""
    if not found.is_complete:
        laboratory_rows = [{**o, **({"laboratory": o["curve"]} if o["is_curve"] else {})} for o in found.laboratory]
        rows = [[numbers.name(o["figure"]), as_written(o["figure"], o["laboratory"]),
                 as_written(o["figure"], o.get("deviation", ""))] for o in laboratory_rows]
        return html.table(["figure", "laboratory", "deviation"], rows)
    rows = []
    for o in found.estimate["observables"]:
        rows.append([numbers.name(o["figure"]), numbers.figure(o["figure"], o["laboratory"], o["standard_error"]),
                     numbers.figure(o["figure"], o["deviation"], digits=2), numbers.count(o["repeats"]),
                     numbers.figure(o["figure"], o.get("discrepancy", 0.0), digits=2), numbers.count(o["runs"]),
                     numbers.signed(o["nearest_off_by"])])
    head = ["figure", "laboratory ± standard error", "deviation", "repeats", "discrepancy of the model",
            "runs that have it",
            "nearest point off by, standard deviations"]
    return html.table(head, rows, numeric=range(1, 7))


def surfaces(found, runs):
    """Contours of each figure with the runs, the laboratory and the region."""
    if not found.is_complete:
        return ""
    note = html.paragraph("Marks are runs: point at one for its figures, follow it to its pile. Dashed is the "
                          "laboratory's value with a band of two standard errors, red the region.", "none")
    if len(found.parameters) > 3:
        return ""
    if found.surfaces is None:
        return note + html.gallery([html.picture(svg.of_figure(plots.line(found, figure, parameter),
                                                               f"{figure} over {parameter}", runs.text,
                                                            runs.has_box))
                                    for figure in found.figures for parameter in found.parameters])
    shown = [html.picture(svg.of_figure(plots.contours(found, figure), f"contours of {figure}", runs.text,
                                        runs.has_box)) for figure in found.figures]
    return note + html.gallery([*shown, html.picture(svg.of_figure(plots.crossing(found), "where they meet"))])


def prior_text(parameter):
    prior = parameter["prior"]
    if prior["kind"] == "uniform":
        return f"uniform, {numbers.plain(parameter['min'])} to {numbers.plain(parameter['max'])}"
    return f"{prior['kind']}, {numbers.with_error(prior['mean'], prior['deviation'])}"


def posterior(found):
    """Samples of what is known of each parameter and of each pair."""
    if not found.is_complete or found.posterior is None:
        return ""
    rows = []
    for p in found.estimate["parameters"]:
        marginal = found.posterior.marginals[p["name"]]
        share = marginal["deviation"] / marginal["prior_deviation"]
        rows.append([html.word(p["name"]), prior_text(p),
                     numbers.number(p["name"], marginal["mean"], marginal["deviation"]),
                     numbers.number(p["name"], marginal["median"]),
                     interval_text(marginal["interval"], marginal["deviation"]),
                     numbers.data(f"{100 * share:.0f} %", share)])
    note = html.paragraph("Each parameter with its prior (dashed) and its interval (red), and each pair with the regions "
                          "that hold 68 and 95 % of it; the star is the best point.", "none")
    share = f"{100 * found.estimate['confidence']:.0f} % interval"
    return (note + html.picture(svg.of_figure(plots.corner(found), "posterior")) +
            html.table(["parameter", "prior", "mean ± deviation", "median", share, "width over that of the prior"], rows,
                       numeric=range(2, 6)))


def curves(found):
    """Those of the laboratory, and what the components have of them."""
    if not found.is_complete:
        return ""
    rows = [[html.escape(c["name"]), numbers.count(len(c["x"])), numbers.count(len(c["components"])),
             numbers.data(f"{100 * c['left_out']:.2g} %", c["left_out"]),
             numbers.data(numbers.plain(c["laboratory_rest"], 2), c["laboratory_rest"])]
            for c in found.estimate.get("curves", ())]
    if not rows:
        return ""
    head = ["curve", "points", "components", "left out of how the runs differ", "laboratory off them, deviations"]
    return (html.gallery([html.picture(svg.of_figure(plots.curve(found, name), f"curve {name}"))
                          for name in found.curves]) + html.table(head, rows, numeric=range(1, 5)))


def convergence(found):
    if "adaptive" not in found.deck:
        return ""
    if found.search is None:
        return html.paragraph("This search has left no search.csv: its convergence was not recorded.", "none")
    rows = [[numbers.data(f"{row['points']:g}", float(row["points"])),
             numbers.data(f"{row['runs']:g}", float(row["runs"])),
             numbers.data(numbers.plain(float(row["core_hours"]), 3), float(row["core_hours"])),
             numbers.data(f"{100 * row['half_width']:.1f} %" if row["half_width"] == row["half_width"] else "none",
                          float(row["half_width"]))] for row in map(found.search.row, range(found.search.rows))]
    return (html.picture(svg.of_figure(plots.search(found), "convergence of the search")) +
            html.table(["points", "runs", "core-hours", "half-width of the widest interval over its range"], rows,
                       numeric=range(4)))


def levels(found):
    """Of the model: what each has cost, and how they are linked."""
    if not found.is_complete or "levels" not in found.estimate:
        return ""
    estimate = found.estimate
    rows = [[html.escape(level["name"]), numbers.count(level["points"]), numbers.count(level["runs"]),
             numbers.data(numbers.plain(level["core_hours"], 3), level["core_hours"])] for level in estimate["levels"]]
    text = html.table(["level", "points", "runs", "core-hours"], rows, numeric=(1, 2, 3))
    left_out = found.levels[len(rows):]  # see known_levels in src/campaign/level_report.h
    if left_out:
        text += html.paragraph(html.escape(f"Left out of the estimate: {' and '.join(left_out)}. Too few points of {left_out[0]} are "
                                           "done with a value of each figure for a surface as yet."))
    links = [[numbers.name(o["figure"]), html.escape(f"{link['level']} of {link['below']}"),
              numbers.number("rho", link["rho"], link["rho_standard_error"]),
              numbers.data(f"{100 * link['explained']:.0f} %" if link["explained"] is not None else "none",
                           link["explained"]),
              html.escape(link.get("scatter_from", link["level"]))]
             for o in estimate["observables"] for link in o.get("links", ())]
    return text + html.table(["figure", "levels", "rho", "explained", "runs scatter as"], links, numeric=(2, 3))


def other_estimate(estimate, content, title):
    """What a part of the runs, or of what was asked, would say."""
    other = {**estimate, **content}
    text = html.element("h3", html.escape(title)) + html.paragraph(html.escape(other["verdict"]))
    text += "".join(point_lines(other, point) for point in other["points"])
    if not other["points"] and other["nearest"]["acceptable"]:
        text += nearest_lines(other)
    return text + other_part_lines(other)


def other_estimates(found):
    """The estimates beside that of all runs: of the cheapest level, of each test, without a discrepancy."""
    if not found.is_complete:
        return ""
    estimate = found.estimate
    others = list(estimate.get("experiments_alone", {}).items())
    if "first_level_alone" in estimate:
        others.insert(0, (f"{found.levels[0]} alone", estimate["first_level_alone"]))
    if "without_discrepancy" in estimate:
        others.append(("without the discrepancy of the model", estimate["without_discrepancy"]))
    return "".join(other_estimate(estimate, content, title) for title, content in others)


def pictures_of_nearest(found, runs, pictures, rows):
    return "".join(html.element("h3", html.escape(runs.name(row)), id=f"pile-{row}") + pictures.of_run(runs.runs[row]) +
                   parts.course(runs.runs[row], plots) * (row == rows[0]) for row in rows)


def report(found):
    """The `Report` of a `Calibration`."""
    has_runs = found.has_grid
    order = found.nearest_runs if found.is_complete and has_runs else []
    runs, pictures = study.Runs(found, found.figures, order) if has_runs else None, parts.Pictures()
    order = [row for row in order if runs.runs[row]]
    nearest = order[:SHOWN]
    sections = [Section("posterior", "Posterior", posterior(found)),
                Section("surfaces", "Contours", surfaces(found, runs)),
                Section("curves", "Curves", curves(found)),
                Section("asked", "What was asked", asked(found)),
                Section("nearest", "Runs nearest the answer", pictures_of_nearest(found, runs, pictures, nearest)),
                Section("search", "Convergence of the search", convergence(found)),
                Section("levels", "Levels of the model", levels(found)),
                Section("others", "What a part of it says", other_estimates(found))]
    if runs:
        sections += [Section("runs", "Runs", runs.table()),
                     Section("boxes", "Each run", runs.boxes(pictures, nearest)),
                     study.repeat(found, runs, "calibrate", (runs.runs[nearest[0]], runs.folders[nearest[0]])
                                  if nearest else None)]
    return Report("calibration", found.title, answer(found), study.state(found), warnings(found, runs), sections)
