"""Numbers as a person reads them, with no more digits than their uncertainty allows. The exact value of the file stays
with each, in `<data value="...">` and, with its key, in the text that appears under the pointer."""

import math

from repose.report.html import escape
from repose.units import display, quantity as named

MOST_DECIMALS = 6
UP = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


def is_number(value):
    return value is not None and math.isfinite(value)


def power(number, digits):
    """In scientific notation."""
    mantissa, exponent = f"{number:.{max(digits - 1, 0)}e}".split("e")
    return f"{mantissa} · 10{str(int(exponent)).translate(UP)}"


def plain(value, digits=4):
    """With so many significant digits; an integer as it is."""
    if not is_number(value):
        return "none"
    if float(value).is_integer() and abs(value) < 1e6:
        return str(int(value))
    if 1e-4 <= abs(value) < 1e6:
        decimals = digits - 1 - math.floor(math.log10(abs(value)))
        return f"{round(value, decimals):.{max(decimals, 0)}f}"
    return power(value, digits)


def with_error(value, error):
    """Value and standard error, both to the second digit of the error: 22.12 ± 0.74. The value alone where the error is less than
    a person reads of it."""
    if not is_number(value):
        return "none"
    if not is_number(error) or error <= 0.0:
        return plain(value)
    decimals = 1 - math.floor(math.log10(float(f"{error:.1e}")))
    if decimals > MOST_DECIMALS:
        exponent = math.floor(math.log10(max(abs(value), error)))
        if decimals + exponent > MOST_DECIMALS:
            return plain(value, MOST_DECIMALS)
        scale = 10.0 ** -exponent
        return f"({with_error(scale * value, scale * error)}) · 10{str(exponent).translate(UP)}"
    shown = max(decimals, 0)
    return f"{round(value, decimals):.{shown}f} ± {round(error, decimals):.{shown}f}"


def data(text, value, title=""):
    """A text with the number of the file behind it."""
    if not is_number(value):
        return f'<span class="none">{escape(text)}</span>'
    text = "−" + text[1:] if text.startswith("-") else text
    hover = f' title="{escape(title)}"' if title else ""
    return f'<data value="{value!r}"{hover}>{escape(text)}</data>'


def figure(name, value, error=None, with_unit=True, digits=4):
    """A figure in the unit that a person reads, for HTML; `digits` counts where there is no error."""
    _, unit, factor = display(name)
    scaled = factor * value if is_number(value) else None
    if factor == 1.0:  # a count stays an integer
        scaled = value
    text = with_error(scaled, factor * error) if is_number(error) and error > 0.0 else plain(scaled, digits)
    title = f"{name} = {value!r}" + (f", standard error {error!r}" if is_number(error) else "")
    return data(text + (f" {unit}" if with_unit and unit and is_number(value) else ""), value, title)


def signed(value, digits=2):
    """With its sign and so many decimals."""
    return data(f"{round(value, digits) + 0.0:+.{digits}f}" if is_number(value) else "none", value)


def beside(name, value, error):
    """A number to as many digits as one with this error has, without it."""
    head, _, tail = with_error(value, error).partition(" ±")
    return data(head.lstrip("(") + tail.partition(")")[2], value, f"{name} = {value!r}")


def number(name, value, error=None):
    """A number that is no figure, such as a parameter: in SI."""
    title = f"{name} = {value!r}" + (f", standard error {error!r}" if is_number(error) else "")
    return data(with_error(value, error), value, title)


def duration(seconds):
    """In words."""
    if not is_number(seconds):
        return "none"
    if seconds < 120.0:
        return f"{seconds:.3g} s"
    if seconds < 7200.0:
        return f"{seconds / 60.0:.3g} min"
    return f"{seconds / 3600.0:.3g} h"


def quantity(name):
    """A figure's name with its unit."""
    return named(name)[0]


def name(figure):
    """A figure's name for HTML."""
    return escape(display(figure)[0])


def count(number):
    """A whole number."""
    return data(str(number), number)
