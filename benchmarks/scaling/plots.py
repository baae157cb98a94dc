"""Pictures of the results, beside them."""

import json

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def draw_all(args):
    for path in sorted(args.results.glob("*.json")):
        content = json.loads(path.read_text())
        draw = scaling if "case" in content else timeline if "runs" in content and "rows" in content else \
            parts if "rows" in content and "table" not in content else efficiency if "assumptions" in content else None
        if draw is None:
            continue
        figure = draw(content)
        figure.tight_layout()
        args.work.mkdir(parents=True, exist_ok=True)
        figure.savefig(args.work / f"{path.stem}.png", dpi=120)
        plt.close(figure)
        print(f"wrote {args.work / path.stem}.png")


def scaling(content):
    table = content["table"]
    ranks = [row["ranks"] for row in table]
    figure, axes = plt.subplots(2, 3, figsize=(11, 6))
    panels = {"wall s": "time of the loop (s)", "efficiency": "parallel efficiency, by wall time",
              "efficiency of the work": "the same by cpu time of the work", "imbalance of pairs": "busiest rank over the mean",
              "ghosts per grain": "ghosts per grain", "communication share": "share of ghosts and agreement"}
    for axis, (key, title) in zip(axes.flat, panels.items()):
        axis.plot(ranks, [row[key] for row in table], "o-", label="pairs")
        if key == "imbalance of pairs":
            axis.plot(ranks, [row["of cpu time"] for row in table], "s--", label="cpu time of the work")
            axis.legend()
        axis.set(xscale="log", xlabel="ranks", title=title)
        axis.set_xticks(ranks, [str(count) for count in ranks], minor=False)
        axis.minorticks_off()
        axis.set_ylim(bottom=1.0 if key == "imbalance of pairs" else 0.0)
        axis.grid(alpha=0.3)
    return figure


def timeline(content):
    figure, axis = plt.subplots(figsize=(7, 4))
    names = {"first": "planes of the start", "bound": "planes renewed when out of bounds"}
    for planes, name in names.items():
        rows = [row for row in content["rows"] if row["planes"] == planes]
        axis.plot([row["time_s"] for row in rows], [row["pair_imbalance"] for row in rows], label=name)
    axis.axhline(1.1, color="grey", linestyle=":", label="max_imbalance = 1.1")
    axis.set(xlabel="time (s)", ylabel="pairs of the busiest part over the mean", ylim=(1.0, None),
             title=f"{content['ranks']} parts")
    axis.legend()
    axis.grid(alpha=0.3)
    return figure


def parts(content):
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.6))
    panels = {"ghosts per grain": lambda r: r["ghosts_per_particle"], "busiest part over the mean": lambda r: r["pair_imbalance"],
              "neighbours of a part": lambda r: r["neighbours"]["mean"]}
    rows = [row for row in content["rows"] if row["planes"] == "new"]
    for axis, (title, pick) in zip(axes, panels.items()):
        for step in sorted({row["step"] for row in rows}):
            of = [row for row in rows if row["step"] == step]
            axis.plot([row["parts"] for row in of], [pick(row) for row in of], "o-", markersize=3, label=f"{of[0]['time_s']:.2f} s")
        axis.set(xscale="log", xlabel="parts", title=title)
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=7)
    return figure


def efficiency(content):
    figure, axis = plt.subplots(figsize=(7, 4))
    for scene in dict.fromkeys(row["scene"] for row in content["table"]):
        of = [row for row in content["table"] if row["scene"] == scene]
        line, = axis.plot([row["ranks"] for row in of], [row["efficiency"] for row in of], "o-", label=scene)
        axis.plot([row["ranks"] for row in of], [row["if nothing is hidden"] for row in of], ":", color=line.get_color())
    axis.set(xscale="log", xlabel="ranks", ylabel="parallel efficiency", ylim=(0.0, 1.05),
             title="Model; dotted: no message is hidden")
    axis.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    axis.grid(alpha=0.3)
    return figure
