"""How a search of a calibration has come to its end."""

from repose.plots.style import HEIGHT, WIDTH, new_figure, styled


@styled
def search(study):
    """The widest interval of the region over its range, after each batch of a `Calibration`; None when it was no
    search."""
    found = study.search
    if found is None:
        return None
    figure, axes = new_figure(figsize=(WIDTH, HEIGHT))
    axes.semilogy(found["runs"], 100.0 * found["half_width"], "o-", label="widest interval, half of it over its range")
    target = study.deck["adaptive"]["half_width"]
    axes.axhline(100.0 * target, color="black", linewidth=0.8, linestyle="--", label="asked for")
    axes.set(xlabel="runs", ylabel="half-width, %")
    axes.legend()
    return figure
