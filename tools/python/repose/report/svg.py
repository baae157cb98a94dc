"""Pictures within the page: matplotlib's figures and the program's own SVG, made small and free of one another's
names."""

import io
import itertools
import re
import xml.etree.ElementTree as tree

import matplotlib

LINK = "{http://www.w3.org/1999/xlink}href"
NUMBER = re.compile(r"-?\d+\.\d+(?:e-?\d+)?")
COLOUR = re.compile(r"rgb\(([\d.]+)%, ?([\d.]+)%, ?([\d.]+)%\)")
DROPPED = ("metadata", "title")

counter = itertools.count()


def rounded(text, digits=1):
    """Coordinates with so many decimals: a picture of 1200 points shows no more."""
    return NUMBER.sub(lambda match: f"{float(match[0]):.{digits}f}".removesuffix(".0"), text)


def parse(text):
    """The root of an SVG without name spaces, and without what is not drawn."""
    root = tree.fromstring(text)
    for node in root.iter():
        node.tag = node.tag.split("}")[-1]
        if LINK in node.attrib:
            node.set("href", node.attrib.pop(LINK))
        for name in [n for n in node.attrib if n.startswith("{")]:
            del node.attrib[name]
    for parent in list(root.iter()):
        for child in [c for c in parent if c.tag in DROPPED]:
            parent.remove(child)
    return root


def rename(root):
    """Ids of its own, so that several pictures can stand in one page; those that nothing refers to go."""
    prefix = f"p{next(counter)}-"
    text = tree.tostring(root, encoding="unicode")
    used = set(re.findall(r'(?:url\(#|href="#)([^)"]+)', text))
    for node in root.iter():
        name = node.get("id")
        if name is not None:
            if name in used:
                node.set("id", prefix + name)
            else:
                del node.attrib["id"]
        for key, value in node.attrib.items():
            if key == "href" and value.startswith("#"):
                node.set(key, "#" + prefix + value[1:])
            elif "url(#" in value:
                node.set(key, value.replace("url(#", f"url(#{prefix}"))


def finish(root, label):
    """As text, as wide as the page allows."""
    box = root.get("viewBox")
    root.attrib.clear()
    root.attrib.update({"viewBox": box, "role": "img", "aria-label": label})
    return tree.tostring(root, encoding="unicode")


def halo(mark):
    """A ring about a mark to point at, which a fingertip meets, too."""
    use = next(mark.iter("use"), None)
    if use is not None and use.get("x"):
        return tree.Element("circle", {"class": "halo", "cx": use.get("x"), "cy": use.get("y"), "r": "9",
                                       "fill": "#fff",
                                       "fill-opacity": "0"})
    return None


def link_runs(root, runs, is_there):
    """Makes links of the marks whose id begins with "run-": to the first of their runs, with what `runs` says of them,
    if something `is_there` to be shown."""
    for parent in list(root.iter()):
        for place, node in enumerate(list(parent)):
            rows = re.fullmatch(r"run-(\d+(?:-\d+)*)", node.get("id", ""))
            if not rows:
                continue
            numbers = [int(row) for row in rows[1].split("-")]
            target = {"href": f"#run-{numbers[0]}"} if is_there(numbers[0]) else {}
            link = tree.Element("a", {**target, "class": "run"})
            tree.SubElement(link, "title").text = "\n\n".join(runs(number) for number in numbers)
            ring = halo(node)
            link.extend([ring] if ring is not None else [])
            del node.attrib["id"]
            parent.remove(node)
            parent.insert(place, link)
            link.append(node)


def of_figure(figure, label, runs=None, is_there=lambda row: True):
    """A figure of matplotlib; `runs`, a function from a row of a grid to a text, makes its marks of runs links."""
    if figure is None:
        return ""
    buffer = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "repose", "svg.fonttype": "path"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    root = parse(buffer.getvalue())
    for node in root.iter():
        for key in ("d", "transform"):
            if key in node.attrib and node.tag != "clipPath":
                node.set(key, node.get(key) if "scale" in node.get(key) else rounded(node.get(key), 2))
    if runs:
        link_runs(root, runs, is_there)
    keep_links(root)
    return finish(root, label)


def keep_links(root):
    """Renames what belongs to the picture, not the links into the page."""
    links = [(node, node.attrib.pop("href")) for node in root.iter("a") if "href" in node.attrib]
    rename(root)
    for node, target in links:
        node.set("href", target)


def hex_colour(match):
    return "#" + "".join(f"{round(2.55 * float(part)):02x}" for part in match.groups())


def disc_of(node):
    """Centre, radius and colour of a path that is a filled circle, as Cairo writes it; None for others."""
    style, path = node.get("style", ""), node.get("d", "")
    if "stroke:none" not in style or path.count("C") != 4 or path.count("M") != 1 or path.count("L"):
        return None
    numbers = [float(x) for x in re.findall(r"-?[\d.]+", path)]
    if len(numbers) != 26:
        return None
    (x0, y0), (x1, y1), (x2, y2) = numbers[0:2], numbers[6:8], numbers[12:14]
    x, r = 0.5 * (x0 + x2), 0.5 * (x0 - x2)
    if abs(y2 - y0) > 0.01 or abs(x1 - x) > 0.01 or abs(abs(y1 - y0) - r) > 0.01:
        return None
    fill = re.search(r"fill:(rgb\([^)]*\))", style)
    return x, y0, r, COLOUR.sub(hex_colour, fill[1])


def shrink_discs(root):
    """Grains as circles: each is a disc with a smaller one on it, which becomes a circle with a rim."""
    for parent in list(root.iter()):
        children, kept = list(parent), []
        for node in children:
            disc = disc_of(node) if node.tag == "path" else None
            if disc is None:
                kept.append(node)
                continue
            x, y, r, colour = disc
            last = kept[-1] if kept and kept[-1].tag == "circle" else None
            rim = float(last.get("r")) - r if last is not None else 0.0
            if last is not None and "stroke" not in last.attrib and 0.0 < rim < 0.4 * r and (
                    abs(float(last.get("cx")) - x) < 0.1 and abs(float(last.get("cy")) - y) < 0.1):
                last.attrib.update({"r": f"{r + 0.5 * rim:.1f}", "fill": colour, "stroke": last.get("fill"),
                                    "stroke-width": f"{rim:.1f}"})
                parent.set("stroke-width", f"{rim:.1f}")
            else:
                kept.append(tree.Element("circle",
                                         {"cx": f"{x:.1f}", "cy": f"{y:.1f}", "r": f"{r:.1f}", "fill": colour}))
        parent[:] = kept
        for circle in kept:  # what they have in common stands above them
            if circle.tag == "circle" and circle.get("stroke-width") == parent.get("stroke-width"):
                circle.attrib.pop("stroke-width", None)


def shrink_image(reference, width):
    """A picture in a `data:` reference, no finer than so many pixels and in 128 colours."""
    import base64

    from PIL import Image
    with Image.open(io.BytesIO(base64.b64decode(reference.split(",", 1)[1]))) as image:
        image = image.convert("RGBA")
        if image.width > width:
            image = image.resize((width, round(image.height * width / image.width)))
        ground = Image.new("RGBA", image.size, "white")
        ground.alpha_composite(image)
        buffer = io.BytesIO()
        ground.convert("RGB").quantize(128).save(buffer, "png", optimize=True)
    return "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode()


def of_file(path, label):
    """A picture that the program has made, at a tenth of its size."""
    root = parse(path.read_text(encoding="utf-8"))
    shrink_discs(root)
    for node in root.iter():
        if node.tag == "image" and node.get("href", "").startswith("data:"):
            node.set("href", shrink_image(node.get("href"), 1200))
        if "style" in node.attrib:
            node.set("style", COLOUR.sub(hex_colour, node.get("style")).replace("fill-opacity:1;", "").strip())
        for key in ("d", "x", "y"):
            if key in node.attrib:
                node.set(key, rounded(node.get(key)))
    rename(root)
    return finish(root, label)
