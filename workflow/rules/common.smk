"""What the study asks for: cases, figures, digests. Stops before the DAG when the study is faulty."""

from pathlib import Path

from snakemake.exceptions import WorkflowError
from snakemake.logging import logger

from orthocut.figures.registry import caption, dims
from orthocut.params.block import ConfigError
from orthocut.params.identity import canonical, digest_datasets, digest_numbers, digest_pictures
from orthocut.plan import load_plan

STUDY = Path(workflow.basedir, "workflow/config", f"{config.get('study', 'quick')}.yaml")
RESULTS = config.get("results", "results")
try:
    PLAN = load_plan(Path(config.get("study_file", STUDY)))
except ConfigError as error:
    raise WorkflowError(str(error)) from None

logger.info("", extra={"cases": PLAN.announcement()})


wildcard_constraints:
    method="mpm|dem",
    case_id="|".join(PLAN.cases) or "none",
    figure="|".join(PLAN.figures) or "none",


def method_of(case_id):
    """Return mpm or dem."""
    return PLAN.cases[case_id].kind.split("_")[0]


def runs_of(figure):
    """Files of the runs that a figure draws."""
    return [f"{RESULTS}/runs/{case}.nc" for case in PLAN.figures[figure]]


def dataset_of(figure):
    """File that a figure draws; none for a figure of theory alone."""
    return [f"{RESULTS}/datasets/{figure}.nc"] if PLAN.figures[figure] else []
