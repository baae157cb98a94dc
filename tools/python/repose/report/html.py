"""Pieces of HTML. All of it is well-formed XML, too, so that a test can read it."""

import html as standard

from repose.units import words


def escape(text):
    return standard.escape(str(text), quote=True)


def word(name):
    """A name of a deck, as it is read."""
    return escape(words(name))


def element(tag, content="", **attributes):
    """`class_` and others with an underscore at the end lose it; those that are None are left out."""
    shown = "".join(f' {name.rstrip("_").replace("_", "-")}="{escape(value)}"' for name, value in attributes.items()
                    if value is not None)
    return f"<{tag}{shown}>{content}</{tag}>"


def paragraph(content, class_=None):
    return element("p", content, class_=class_)


def line(name, content):
    """Of the answer: what it is, and its value."""
    return paragraph(element("span", escape(name), class_="name") + " " + content, "large")


def table(head, rows, class_=None, numeric=()):
    """A table of cells in HTML; with the class "sortable" a click on its head sorts it. Columns in `numeric` stand
    right."""
    def cells(tag, row):
        scope = "col" if tag == "th" else None
        return "".join(element(tag, cell, class_="number" if k in numeric else None, scope=scope)
                       for k, cell in enumerate(row))
    body = "".join(element("tr", cells("td", row)) for row in rows)
    top = element("thead", element("tr", cells("th", head))) if head else ""
    return element("div", element("table", top + element("tbody", body), class_=class_), class_="wide")


def pairs(rows):
    """Names and values, one below the other."""
    return element("dl", "".join(element("dt", name) + element("dd", value) for name, value in rows))


def details(title, content, id_=None, is_open=False):
    return element("details", element("summary", title) + content, id=id_, open="open" if is_open else None)


def code(text):
    return element("pre", element("code", escape(text)))


def items(texts, class_=None):
    return element("ul", "".join(element("li", text) for text in texts), class_=class_)


def picture(svg, caption=""):
    return element("figure", svg + (element("figcaption", caption) if caption else ""))


def gallery(pictures):
    """Pictures side by side where there is room."""
    pictures = [p for p in pictures if p]
    return element("div", "".join(pictures), class_="gallery") if pictures else ""
