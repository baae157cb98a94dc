"""The report of a sensitivity study."""

from repose import plots
from repose.report import html, numbers, parts, study, svg
from repose.report.page import Report, Section


NO_EFFECT = '<span class="none">no effect above two standard errors</span>'
NO_ERROR = "With one seed an effect has no standard error: what the runs scatter by is not known, and all effects are listed."


def effect_text(figure, effect):
    value = numbers.figure(figure, effect["effect"], effect["standard_error"])
    return f"{html.word(effect['parameter'])} <b>{value}</b>"


def matters(effect):
    """Whether an effect is more than twice its standard error, as far as that is known."""
    error = effect["standard_error"]
    return effect["effect"] is not None and (error is None or abs(effect["effect"]) > 2.0 * error)


def answer(found):
    """Which parameter does most to each figure."""
    if not found.is_complete:
        return html.paragraph("There are no effects yet.")
    rows = []
    for figure in found.figures:
        effects = [e for e in found.effects(figure).values() if matters(e)]
        effects.sort(key=lambda e: -abs(e["effect"]))
        told = "<br/>".join(effect_text(figure, e) for e in effects) or NO_EFFECT
        rows.append((numbers.name(figure), told))
    has_errors = all(e["standard_error"] is not None for figure in found.figures for e in found.effects(figure).values()
                     if e["effect"] is not None)
    return html.pairs(rows) + html.paragraph(
        "Effects from the lower to the upper value of a parameter, the others at their fixed values; those of more "
        "than two standard errors, the greatest first." + ("" if has_errors else " " + NO_ERROR), "none")


def sample(figure, found):
    return numbers.figure(figure, found["mean"], found["deviation"], with_unit=False)


def tables(found):
    """All effects of each figure, to be sorted."""
    text = ""
    for figure in found.figures:
        rows = [[html.word(name), sample(figure, e["lower"]), sample(figure, e["upper"]),
                 numbers.figure(figure, e["effect"], e["standard_error"], with_unit=False)]
                for name, e in found.effects(figure).items()]
        walks = found.morris(figure)
        head = ["parameter", "at the lower value", "at the upper value", "effect"]
        if walks:
            head += ["Morris mu*", "mu", "sigma"]
            for row, e in zip(rows, walks.values()):
                row += [numbers.figure(figure, e["mu_star"], e["mu_star_error"], with_unit=False),
                        numbers.figure(figure, e["mu"], e["mu_error"], with_unit=False),
                        numbers.figure(figure, e["sigma"], with_unit=False, digits=2)]
        text += html.element("h3", html.escape(numbers.quantity(figure)))
        if any(e["effect"] is not None for e in found.effects(figure).values()):
            kinds = ["one_at_a_time", "morris"] if walks else ["one_at_a_time"]
            text += html.gallery([html.picture(svg.of_figure(plots.effect(found, figure, kind),
                                                             f"effects on {figure}")) for kind in kinds])
        text += html.table(head, rows, "sortable", numeric=range(1, len(head)))
    return text + html.paragraph("± of values is their standard deviation from seed to seed, of effects the standard "
                                 "error.", "none")


def asked(found):
    deck = found.deck
    rows = study.asked(deck)
    if "morris" in deck:
        design = ", ".join(f"{key} = {value}" for key, value in deck["morris"].items())
        rows.append(("walks of Morris", html.escape(design)))
    ranges = [[html.word(p["name"]), f"<code>{html.escape(p['key'])}</code>", html.escape(p["min"]),
               html.escape(p["fixed"]), html.escape(p["max"])] for p in deck["parameter"]]
    return html.pairs(rows) + html.table(["parameter", "key", "lower", "fixed", "upper"], ranges, numeric=(2, 3, 4))


def missing(found):
    """Figures of which there is no effect at all."""
    if not found.is_complete:
        return []
    return [f"There is no effect on {numbers.name(figure)}: runs at the ends of the ranges have none."
            for figure in found.figures if all(e["effect"] is None for e in found.effects(figure).values())]


def report(found):
    """The `Report` of a `Sensitivity`."""
    has_runs = found.has_grid
    runs = study.Runs(found, found.figures) if has_runs else None
    sections = [Section("effects", "Effects", tables(found) if found.is_complete else ""),
                Section("asked", "What was asked", asked(found))]
    if runs:
        sections += [Section("runs", "Runs", runs.table()),
                     Section("boxes", "Each run", runs.boxes(parts.Pictures())),
                     study.repeat(found, runs, "sensitivity", None)]
    return Report("sensitivity study", found.title, answer(found), study.state(found),
                  missing(found) + (study.warnings(runs) if runs else []), sections)
