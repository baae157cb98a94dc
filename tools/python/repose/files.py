"""Files of the program: JSON, tables (CSV), decks (TOML)."""

import csv
import io
import json
import pathlib
import tomllib

import numpy as np


class ReposeError(Exception):
    """One line: where, what, and what would be right. `code` is the exit code of the program, if it was the program
    that failed (2: the deck is wrong, 3: the physics broke, 4: a file, 75: stopped with a checkpoint)."""

    def __init__(self, message, code=None):
        super().__init__(message)
        self.code = code


class Table(dict):
    """Columns of a CSV by name, in the order of the file: numpy arrays of floats, with NaN where a field is empty, or
    of texts."""

    @property
    def rows(self):
        """How many."""
        return len(next(iter(self.values()))) if self else 0

    def row(self, number):
        """One row as a dict."""
        return {name: column[number] for name, column in self.items()}

    def frame(self):
        """As a pandas.DataFrame; pandas has to be installed."""
        import pandas
        return pandas.DataFrame(dict(self))


def read_text(path):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise ReposeError(f"{path}: cannot be read: {getattr(error, 'strerror', None) or error}") from None


def read_json(path):
    """The content of a JSON file of the program."""
    try:
        return json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise ReposeError(f"{path}: is damaged: {error}") from None


def read_toml(path):
    """A deck as it stands, without the defaults of the program unless it is a resolved one."""
    try:
        return tomllib.loads(read_text(path))
    except tomllib.TOMLDecodeError as error:
        raise ReposeError(f"{path}: is damaged: {error}") from None


def read_rows(path):
    """The fields of a CSV as texts: names of the columns, rows. The last row of a file that grows may not be whole yet
    and is left out then."""
    text = read_text(path)
    names, *rows = list(csv.reader(io.StringIO(text))) or [[]]
    if rows and not text.endswith("\n"):
        rows.pop()
    if any(len(row) != len(names) for row in rows):
        raise ReposeError(f"{path}: is damaged: a row has not {len(names)} fields, as the first line has")
    return names, rows


def column_of(texts):
    """Floats with NaN where a field is empty; texts when one is no number."""
    try:
        return np.array([float(text) if text else np.nan for text in texts])
    except ValueError:
        return np.array(texts)


def read_table(path, texts=()):
    """A CSV by columns; those named in `texts` stay texts."""
    names, rows = read_rows(path)
    columns = zip(*rows) if rows else ([] for _ in names)
    return Table((name, np.array(column, dtype=str) if name in texts else column_of(column))
                 for name, column in zip(names, columns))


def number_in(content, figure, where="summary.json"):
    """The number of a figure, by its name in decks: `scattering.area_1.count` is below two sections. None when it was
    not measured or is not there to be measured."""
    value = content
    for part in figure.split("."):
        if not isinstance(value, dict) or part not in value:
            raise ReposeError(f'figure "{figure}": {where} has no such key')
        value = value[part]
        if value is None:
            return None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ReposeError(f'figure "{figure}": is not one number')
    return value
