"""The tables of docs/validation.md: what stands in a row with the state hash of a run is what benchmarks/results/validation has of it.

Not looked at are differences between runs (columns "less ..."), and what is the machine's (processor, time).

Usage: validation_tables_test.py SOURCE_DIR
"""

import gzip
import json
import pathlib
import re
import sys

HASH = re.compile(r"\b[0-9a-f]{32}\b")
NUMBER = re.compile(r"-?\d+\.?\d*(?:e-?\d+)?")
FACTORS = (1.0, 1e2, 1e3, 1e6, 1.0 / 60.0)  # %; g, mm; um, us; min
FEW = 4  # runs of a file whose tables may do without hashes


def numbers_in(content):
    """All numbers of a JSON, those within texts too."""
    if isinstance(content, (int, float)):
        yield float(content)
    elif isinstance(content, str):
        yield from map(float, NUMBER.findall(HASH.sub("", content)))
    elif content is not None:
        for value in content.values() if isinstance(content, dict) else content:
            yield from numbers_in(value)


def collect(content, found):
    """Adds to {hash: numbers} those of the largest parts of a JSON that are of one run alone."""
    own = set(HASH.findall(json.dumps(content)))
    if len(own) == 1:
        found.setdefault(own.pop(), set()).update(numbers_in(content))
    elif own and not isinstance(content, str):
        for value in content.values() if isinstance(content, dict) else content:
            collect(value, found)


def results_of(folder):
    """{hash: numbers} of all that studies have written."""
    found = {}
    for path in sorted(folder.glob("*.json")):
        content = json.loads(path.read_text())
        own = set(HASH.findall(path.read_text()))
        if len(own) <= FEW:
            for state in own:
                found.setdefault(state, set()).update(numbers_in(content))
        collect(content, found)
    for path in sorted(folder.glob("runs/*.jsonl.gz")):
        for line in gzip.decompress(path.read_bytes()).decode().splitlines():
            collect(json.loads(line), found)
    return found


def rows_with_hashes(text):
    """(line number, {column: cell}, hashes) of the tables of a document."""
    head = None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.lstrip().startswith("|"):
            head = None
            continue
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if head is None:
            head = cells
        elif HASH.search(line):
            yield number, dict(zip(head, cells)), HASH.findall(line)


def is_among(text, numbers):
    """Whether a number, as it was rounded, is one of these in another unit."""
    half = 0.5000001 * 10.0 ** -len(text.partition(".")[2])
    return any(abs(abs(value * factor) - float(text)) <= half for value in numbers for factor in FACTORS)


def wrong_cells(number, row, known):
    for column, cell in row.items():
        if column.startswith(("less ", "processor", "time, min")):
            continue
        plain = re.sub(r"`[^`]*`", "", cell)
        for text in re.findall(r"\d+\.?\d*", re.sub(r"(?<=\d) (?=\d{3}\b)", "", plain)):
            if not is_among(text, known):
                yield f"docs/validation.md:{number}: {column}: {text} is not among the results of that run"


def main():
    source = pathlib.Path(sys.argv[1])
    results = results_of(source / "benchmarks" / "results" / "validation")
    rows, wrong = 0, []
    for number, row, states in rows_with_hashes((source / "docs" / "validation.md").read_text(encoding="utf-8")):
        rows += 1
        unknown = [state for state in states if state not in results]
        wrong += [f"docs/validation.md:{number}: no result has the state {state}" for state in unknown]
        if not unknown:
            wrong += wrong_cells(number, row, set().union(*(results[state] for state in states)))
    assert rows > 20, f"only {rows} rows with a state hash"
    for line in wrong:
        print(line)
    print(f"{rows} rows")
    sys.exit(1 if wrong else 0)


main()
