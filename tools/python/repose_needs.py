"""What the tools beside this folder need, said in one line where it is not there. It imports nothing that may be missing, and
runs on any Python 3."""

import importlib.util
import os
import sys


def need(*modules):
    """Ends the program when one of these modules of Python is not installed, or Python itself is too old."""
    name = os.path.basename(sys.argv[0])
    if sys.version_info < (3, 11):
        sys.exit(f"{name}: needs Python 3.11 or newer")
    missing = [module for module in modules if importlib.util.find_spec(module) is None]
    if missing:
        packages = " ".join(f"python3-{module}" for module in modules)
        sys.exit(f"{name}: needs {', '.join(missing)} (Debian: {packages})")
