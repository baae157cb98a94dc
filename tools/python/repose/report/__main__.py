"""python3 -m repose.report DIR [--output FILE.html]"""

import pathlib
import runpy

runpy.run_path(str(pathlib.Path(__file__).parents[2] / "repose_report.py"), run_name="__main__")
