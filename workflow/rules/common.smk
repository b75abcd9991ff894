"""What the study asks for and what the store lacks. Stops before the DAG when the study is faulty."""

import sys
from pathlib import Path

from snakemake.exceptions import WorkflowError
from snakemake.logging import logger

from orthocut.figures.registry import caption, condense, dims
from orthocut.io.files import hold
from orthocut.io.store import IN_USE, Store
from orthocut.params.block import ConfigError
from orthocut.params.identity import digest_datasets, digest_numbers, digest_pictures, digest_report, result_key
from orthocut.params.workflow import WorkflowOptions
from orthocut.plan import draws_fields, load_plan
from orthocut.survey import read_batch, survey

try:
    OPTIONS = WorkflowOptions.read(config)
    if workflow.is_main_process:
        OPTIONS.check_folders(Path.cwd())
    PLAN = load_plan(OPTIONS.study_path(Path(workflow.basedir)))
except ConfigError as error:
    raise WorkflowError(str(error)) from None

RESULTS, STORE = OPTIONS.results, OPTIONS.store_path
ATTEMPTS = Store(STORE).attempts()
BATCHES, BATCH_OF = {}, {}
if workflow.is_main_process:
    SURVEY = survey(PLAN, Store(STORE))
    BATCHES = {batch.name: batch for batch in SURVEY.batches(OPTIONS.batch_cores, OPTIONS.batch_minutes)}
    BATCH_OF = {job.case_id: batch.name for batch in BATCHES.values() for job in batch.jobs}
    for name in BATCHES:  # a mark of a batch that lacks results is of an earlier run
        Path(RESULTS, "batches", f"{name}.done").unlink(missing_ok=True)
    logger.info(SURVEY.summary(), extra={"cases": SURVEY.announcement(), "progress": f"{RESULTS}/progress"})


onstart:
    try:
        hold(Path(RESULTS, ".lock"))
    except BlockingIOError as error:
        raise WorkflowError(f"{RESULTS}: {error.strerror}: wait until that workflow ends") from None
    try:
        hold(Path(STORE, IN_USE), shared=True)
    except BlockingIOError as error:
        raise WorkflowError(f"{STORE}: {error.strerror}: wait until it is cleaned up") from None
    except OSError:  # a store that can only be read is not cleaned up either
        pass
    for path in Path(RESULTS, "batches").glob("*"):
        if path.stem not in BATCHES:
            path.unlink()
    for batch in BATCHES.values():
        batch.write(Path(RESULTS, "batches"))


wildcard_constraints:
    method="mpm|dem",
    batch="(case|batch)-[a-z0-9-]+",
    figure="|".join(PLAN.figures) or "none",


def batch_of(wildcards):
    """Batch of a job; a job on another machine reads it from the file that the main process wrote."""
    return BATCHES.get(wildcards.batch) or read_batch(Path(RESULTS, "batches", f"{wildcards.batch}.json"))


def missing_of(cases):
    """Marks of the batches that simulate what is missing of some cases; none when all are done."""
    return [f"{RESULTS}/batches/{name}.done" for name in dict.fromkeys(BATCH_OF[c] for c in cases if c in BATCH_OF)]


def members_of(cases):
    """Names of results, each with its number of snapshots, and of failed attempts before it."""
    keys = {case: result_key(PLAN.cases[case]) for case in cases}
    return [f"{key}#{PLAN.snapshots[case]}#{ATTEMPTS.get(key, 0)}" for case, key in keys.items()]


def dataset_of(figure):
    """File that a figure draws; none for a figure of theory alone."""
    return [f"{RESULTS}/datasets/{figure}.nc"] if PLAN.figures[figure] else []


def sources_of_dataset(figure):
    """Digest of what makes the dataset of a figure; with that of the pictures if the figure has a hand in it."""
    return [digest_datasets(), digest_pictures()] if condense(figure) else digest_datasets()


def figures_of(figures):
    """Pictures and tables of some figures."""
    pictures = [f"{RESULTS}/figures/{figure}.{form}" for figure in figures for form in ("png", "svg")]
    tables = [f"{RESULTS}/tables/{figure}.{form}" for figure in figures for form in ("csv", "md")]
    motions = [f"{RESULTS}/animations/{figure}.gif" for figure in figures if figure in PLAN.animations]
    return pictures + [path for path in tables if Path(path).stem in PLAN.tables] + motions


def minutes(wildcards, threads, attempt):
    """Time limit of a batch: three times the prediction, and more at each attempt."""
    batch = batch_of(wildcards)
    predicted = max(batch.seconds / threads, max(job.seconds for job in batch.jobs))
    return attempt * (10 + int(predicted / 20))


def of_method(word):
    """Figures that draw cases of a method."""
    return [figure for figure, cases in PLAN.figures.items() if any(case.startswith(f"{word}-") for case in cases)]
