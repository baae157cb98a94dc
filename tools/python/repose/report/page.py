"""The page: head, style, script, navigation and sections."""

import datetime
import pathlib
from dataclasses import dataclass

from repose.report.html import element, escape, items

FOLDER = pathlib.Path(__file__).resolve().parent


@dataclass
class Section:
    id: str
    title: str
    content: str


@dataclass
class Report:
    kind: str      # "run", "calibration" and so on
    title: str     # of the deck
    answer: str    # HTML, what is read first
    state: str     # HTML, how far the job is; empty when it is complete
    warnings: list  # HTML
    sections: list


def warnings_html(warnings):
    if not warnings:
        return ""
    return element("section", element("h2", "Warnings") + items(warnings), class_="warnings", id="warnings")


def page(report):
    """The whole file."""
    title = report.title or report.kind
    sections = [section for section in report.sections if section.content]
    links = items([f'<a href="#{s.id}">{escape(s.title)}</a>' for s in sections])
    made = datetime.datetime.now().astimezone().strftime("%d %B %Y, %H:%M %Z")
    body = element("header", element("p", f"repose: {escape(report.kind)}", class_="kind") +
                   element("h1", escape(title)))
    body += element("section", report.state, class_="state") if report.state else ""
    body += element("section", report.answer, class_="answer", id="answer")
    body += warnings_html(report.warnings)
    body += element("nav", links)
    body += "".join(element("section", element("h2", escape(s.title)) + s.content, id=s.id) for s in sections)
    body += element("footer",
                    f"Made by repose report on {escape(made)}. Numbers under the pointer are those of the files.")
    style, script = ((FOLDER / name).read_text(encoding="utf-8") for name in ("page.css", "page.js"))
    return ('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8"/>\n'
            '<meta name="viewport" content="width=device-width, initial-scale=1"/>\n'
            f"<title>{escape(title)}</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n{body}\n</main>\n"
            f"<script>\n{script}</script>\n</body>\n</html>\n")
