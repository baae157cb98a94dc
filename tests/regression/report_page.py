"""A report as a browser and as XML see it, and what holds for each of them: both see the same elements, links lead to
what is there, and nothing is fetched from anywhere."""

import re
import xml.etree.ElementTree as tree
from html.parser import HTMLParser

VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}
ENDS_PARAGRAPH = {"article", "aside", "blockquote", "details", "div", "dl", "figure", "footer", "form", "h1", "h2",
                  "h3", "h4", "header", "hr", "main", "nav", "ol", "p", "pre", "section", "table", "ul"}
FETCHED = ("src", "srcset", "poster", "data", "background", "action", "formaction", "ping", "manifest", "http-equiv")
WHOLE = ("link", "iframe", "img", "object", "embed", "base", "audio", "video", "source", "form")
SVG = "{http://www.w3.org/2000/svg}"


class Tags(HTMLParser):
    """The elements in the order of their beginnings, as HTML reads them; `wrong` has what a browser would mend."""

    def __init__(self, text):
        super().__init__()
        self.names, self.open, self.wrong, self.raw = [], [], [], {"style": "", "script": ""}
        self.feed(text)
        self.close()
        self.wrong += [f"<{name}> is not closed" for name in self.open]

    def begin(self, name):
        self.names.append(name)
        if name in ENDS_PARAGRAPH and "p" in self.open:
            self.wrong.append(f"line {self.getpos()[0]}: <{name}> within <p>")
        if name == "a" and "a" in self.open:
            self.wrong.append(f"line {self.getpos()[0]}: <a> within <a>")

    def handle_starttag(self, name, attributes):
        self.begin(name)
        if name not in VOID or "svg" in self.open:
            self.open.append(name)

    def handle_startendtag(self, name, attributes):
        self.begin(name)
        if name not in VOID and "svg" not in self.open:
            self.wrong.append(f"line {self.getpos()[0]}: <{name}/> is open for a browser")

    def handle_endtag(self, name):
        if not self.open or self.open[-1] != name:
            self.wrong.append(f"line {self.getpos()[0]}: </{name}> closes <{self.open[-1] if self.open else ''}>")
        else:
            self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] in self.raw:
            self.raw[self.open[-1]] += data


class Page:
    """A report as XML."""

    def __init__(self, text):
        self.text = text
        self.root = tree.fromstring(text.split("\n", 1)[1])
        self.ids = [node.get("id") for node in self.root.iter() if node.get("id")]

    def section(self, name):
        return next(node for node in self.root.iter() if node.get("id") == name)

    def words(self, name):
        return " ".join(" ".join(self.section(name).itertext()).split())

    def values(self, name=None):
        """Numbers of the files, as they are behind the texts."""
        nodes = self.section(name) if name else self.root
        return [float(node.get("value")) for node in nodes.iter("data")]

    def titled(self, name=None):
        """{key: numbers} of those that have their key."""
        found = {}
        for node in (self.section(name) if name else self.root).iter("data"):
            match = re.match(r"([\w.]+) = (\S+?)(?:, standard error (\S+))?$", node.get("title", ""))
            if match:
                found.setdefault(match[1], []).append((float(match[2]), float(match[3]) if match[3] else None))
        return found


def check(test, page):
    """What holds for every report."""
    test.assertEqual(page.text.split("\n", 1)[0], "<!DOCTYPE html>")
    tags = Tags(page.text)
    test.assertEqual(tags.wrong, [])
    test.assertEqual(tags.names, [node.tag.removeprefix(SVG).lower() for node in page.root.iter()])
    test.assertEqual(len(page.ids), len(set(page.ids)), "ids that stand twice")
    for node in page.root.iter():
        test.assertNotIn(node.tag.removeprefix(SVG), WHOLE)
        for name, value in node.attrib.items():
            test.assertNotIn(name, FETCHED)
            test.assertFalse(name.startswith("on"), name)
            test.assertNotRegex(value, r"https?:|file:", f"{node.tag} {name}")
            for target in re.findall(r"url\((.*?)\)", value) + ([value] if re.search(r"(^|\})href$", name) else []):
                test.assertTrue(target.startswith("data:image/") or (target[:1] == "#" and target[1:] in page.ids),
                                f"{node.tag} {name}: {target[:60]}")
    for name, forbidden in (("style", r"@import|url\("), ("script", r"fetch|XMLHttp|import\(|http")):
        as_xml = "".join("".join(node.itertext()) for node in page.root.iter() if node.tag.removeprefix(SVG) == name)
        test.assertEqual(as_xml, tags.raw[name], f"<{name}> is another text in HTML")
        test.assertNotRegex(tags.raw[name], forbidden)
