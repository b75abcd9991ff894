"""Run every test of a fault, each of which says what must become of it, and write a table: test, outcome, seconds."""

import argparse
import csv
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

TESTS = [
    "tests/workflow/test_faults.py",
    "tests/verification/test_resume.py",
    "tests/unit/test_store.py",
    "tests/slurm",
]


def outcome(case: ElementTree.Element) -> str:
    """What became of a test, in a word."""
    children = {child.tag for child in case}
    if children & {"failure", "error"}:
        return "FAILED"
    return "not tried here" if "skipped" in children else "passed"


def main() -> None:
    """Run the tests and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("results/benchmarks/faults.csv"))
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder, "faults.xml")
        code = subprocess.run(
            [sys.executable, "-m", "pytest", "-q", "--junitxml", report, *TESTS], check=False
        ).returncode
        cases = list(ElementTree.parse(report).iter("testcase"))
    rows = [
        (
            case.get("name", "").removeprefix("test_").replace("_", " "),
            outcome(case),
            f"{float(case.get('time', 0)):.1f}",
        )
        for case in cases
    ]
    options.output.parent.mkdir(parents=True, exist_ok=True)
    with open(options.output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["fault", "its test", "time [s]"])
        writer.writerows(rows)
    sys.exit(code)


if __name__ == "__main__":
    main()
