"""What a case costs before its first step: import, compilation, packing, lists of neighbours.

Each start is a process of its own, as in the workflow; cold ones have an empty folder of compiled code.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from rich.console import Console
from rich.progress import track
from tables import write_table

HEADER = ["case", "compiled code", "import [s]", "set-up [s]", "first step [s]", "in all before stepping [s]"]
SCRIPTS = {
    "ductile, 8 points": """
from orthocut.params.case import load
from orthocut.mpm import setup
from orthocut.mpm.solver import Solver
note("import")
case = load("mpm", {"points_per_depth": 8})
solver = Solver(setup.build(case))
note("set-up")
solver.advance(1)
note("step")
""",
    "glass, packing from the shelf": """
from pathlib import Path
from orthocut.params.case import load
from orthocut.experiments.dem_cutting import make_scene
from orthocut.experiments.dem_run import proceed
from orthocut.experiments.packing_shelf import packed_discs
from orthocut.io.checkpoint import Checkpoint
note("import")
case = load("dem", {})
scene = make_scene(case, packed_discs(case.packing, Checkpoint(Path(FOLDER) / "case.npz", "case")))
note("set-up")
proceed(scene, 1)
note("step")
""",
    "glass, new packing": """
from orthocut.params.case import load
from orthocut.dem.packing import pack
from orthocut.experiments.dem_cutting import make_scene
from orthocut.experiments.dem_run import proceed
note("import")
case = load("dem", {})
scene = make_scene(case, pack(case.packing))
note("set-up")
proceed(scene, 1)
note("step")
""",
}
FRAME = """
import json, time
START = {start!r}
FOLDER = {folder!r}
marks = {{}}
def note(name):
    marks[name] = time.time() - START
{script}
print(json.dumps(marks))
"""


def main() -> None:
    """Measure and write a table as CSV."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=5, help="warm starts of each case; cold ones are made once")
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/setup_cost.csv"))
    options = parser.parse_args()

    rows = []
    for name, script in SCRIPTS.items():
        with tempfile.TemporaryDirectory() as folder:
            rows.append([name, "none", *start(script, folder)])
            rounds = track(range(options.rounds), name, console=Console(stderr=True))
            warm = [start(script, folder) for _ in rounds]
            rows.append([name, "cached", *(statistics.median(column) for column in zip(*warm, strict=True))])
    write_table(HEADER, rows, options.output)


def start(script: str, folder: str) -> tuple[float, float, float, float]:
    """Start a process; return the times of its import, set-up and first step and their sum [s]."""
    environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "PYTHONDONTWRITEBYTECODE": ""}
    code = FRAME.format(start=time.time(), folder=folder, script=script)
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    marks = json.loads(done.stdout.splitlines()[-1])
    return marks["import"], marks["set-up"] - marks["import"], marks["step"] - marks["set-up"], marks["step"]


if __name__ == "__main__":
    main()
