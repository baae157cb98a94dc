"""What the pictures have in common."""

import matplotlib
from matplotlib.figure import Figure

STYLE = {"font.size": 9, "axes.grid": True, "grid.color": "0.9", "axes.axisbelow": True, "legend.frameon": False,
         "legend.fontsize": 8, "lines.linewidth": 1.3, "pdf.fonttype": 42}
WIDTH, HEIGHT = 4.6, 3.0  # inches; a column and a half of a journal


def styled(draw):
    """A function that draws in this style."""
    def drawn(*arguments, **named):
        with matplotlib.rc_context(STYLE):
            return draw(*arguments, **named)
    drawn.__doc__, drawn.__name__ = draw.__doc__, draw.__name__
    return drawn


def new_figure(rows=1, columns=1, **named):
    """A figure that no screen has to know, and its axes."""
    size = named.pop("figsize", (WIDTH, HEIGHT))
    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, **named)
