"""Runs of the long studies, kept among the results: on another machine, or without the folders of the runs, a study goes on from them."""

import contextlib
import gzip
import json

# What a study reads of a run that has ended
FILES = ("summary.json", "failed.json", "rings.json")
LEFT_OUT = ("timing", "lists", "parallel", "memory")  # keys of summary.json that tell of the machine alone


def _file_of(options, name):
    return options.results / "runs" / f"{name}.jsonl.gz"


def _restore(options, name):
    path = _file_of(options, name)
    if not path.exists():
        return
    for line in gzip.decompress(path.read_bytes()).decode().splitlines():
        record = json.loads(line)
        folder = options.work / record["folder"]
        if any((folder / file).exists() for file in FILES):
            continue
        folder.mkdir(parents=True, exist_ok=True)
        if "summary.json" in record:
            (folder / "deck.resolved.toml").write_text(record["summary.json"]["deck"])
        for file in record.keys() & set(FILES):
            (folder / file).write_text(json.dumps(record[file]))


def _keep(options, name):
    patterns = (f"{name}/runs/**", f"{name}_laboratory_*")
    folders = {found.parent for pattern in patterns for file in FILES for found in options.work.glob(f"{pattern}/{file}")}
    lines = []
    for folder in sorted(folders):
        record = {"folder": str(folder.relative_to(options.work))}
        record |= {file: json.loads((folder / file).read_text()) for file in FILES if (folder / file).exists()}
        for key in LEFT_OUT:
            record.get("summary.json", {}).pop(key, None)
        lines.append(json.dumps(record).replace(f"{options.work}/", "") + "\n")  # messages name files below it
    if lines:
        path = _file_of(options, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(gzip.compress("".join(lines).encode(), mtime=0))  # the same runs, the same bytes


@contextlib.contextmanager
def kept(options, name):
    """Around a study: before it, the folders of its kept runs are written where they are missing; after it, however it ends, what
    has ended of the runs in `name`/runs and `name`_laboratory_* is kept."""
    _restore(options, name)
    try:
        yield
    finally:
        _keep(options, name)
