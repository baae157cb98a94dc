"""The order of the rooms: src/ holds main.cpp, CMakeLists.txt and folders; each folder includes itself and those before it. And
no two headers define a class of the same name in the same namespace: of what the compiler makes for both the linker keeps one.

The order is that of ROOMS in src/CMakeLists.txt; a room with floors lists them in its own CMakeLists.txt, with "." for what
lies in the room itself if that is not first.

Usage: rooms_test.py SOURCE_DIR
"""

import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#include "([^"]+)"', re.M)


def listed(cmake, name):
    """The words of set(NAME ...) in a CMake file."""
    found = re.search(rf"set\({name}\s+([^)]*)\)", cmake.read_text())
    assert found, f"{cmake}: no set({name} ...)"
    return found.group(1).split()


def order_of(src):
    """Folders below src in the order in which they may include one another."""
    order = []
    for room in listed(src / "CMakeLists.txt", "ROOMS"):
        floors = sorted(p.name for p in (src / room).iterdir() if p.is_dir())
        names = listed(src / room / "CMakeLists.txt", "FLOORS") if floors else []
        if "." not in names:
            names.insert(0, ".")
        assert sorted(names) == [".", *floors], f"{room}: FLOORS says {names}, there are {floors}"
        order += [str(pathlib.PurePosixPath(room) / floor) for floor in names]
    return order


def check(src):
    loose = sorted(p.name for p in src.iterdir() if p.is_file())
    assert loose == ["CMakeLists.txt", "main.cpp"], f"src/ holds {loose}"
    order = order_of(src)
    rooms = {p.name for p in src.iterdir() if p.is_dir()}
    assert rooms == {name for name in order if "/" not in name}, f"ROOMS says {order}, there are {sorted(rooms)}"
    place = {name: number for number, name in enumerate(order)}
    seen = 0
    for path in sorted(src.rglob("*")):
        if path.suffix not in (".h", ".cpp", ".in") or path.parent == src:
            continue
        here = str(path.parent.relative_to(src))
        for included in INCLUDE.findall(path.read_text()):
            there = str(pathlib.PurePosixPath(included).parent)
            assert there in place, f"{path.relative_to(src)}: includes {included}, whose folder is no room"
            assert place[there] <= place[here], f"{path.relative_to(src)}: includes {included}, a later room"
            seen += 1
    assert seen > 500, f"only {seen} includes were found"
    print(f"{len(order)} rooms, {seen} includes")


def check_names(src):
    headers = {}
    for path in sorted(src.rglob("*.h")):
        namespace = None
        for line in path.read_text().splitlines():
            opened = re.match(r"namespace ([\w:]+) {", line)
            defined = re.match(r"(?:class|struct) (\w+)(?: final)?(?: :[^;]*)? {", line)
            if opened:
                namespace = opened.group(1)
            elif defined:
                name = f"{namespace}::{defined.group(1)}"
                assert name not in headers, f"{path.relative_to(src)}: {name} is defined in {headers[name]}, too"
                headers[name] = path.relative_to(src)
    assert len(headers) > 300, f"only {len(headers)} classes were found"
    print(f"{len(headers)} classes in headers")


check(pathlib.Path(sys.argv[1]) / "src")
check_names(pathlib.Path(sys.argv[1]) / "src")
