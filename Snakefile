"""Simulations and figures of orthogonal cutting: ``snakemake --cores all --config study=quick``."""

from snakemake.utils import min_version

min_version("9.0")


include: "workflow/rules/common.smk"
include: "workflow/rules/prepare.smk"
include: "workflow/rules/simulate.smk"
include: "workflow/rules/collect.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/animate.smk"
include: "workflow/rules/report.smk"
include: "workflow/rules/calibrate.smk"
include: "workflow/rules/validate.smk"
include: "workflow/rules/targets.smk"


# A few seconds each: not worth a job of a cluster.
localrules:
    collect,
    figure,
    table,
    run_times,
    animate,
    report,


rule all:
    default_target: True
    input:
        rules.runs.input,
        rules.figures.input,
        rules.tables.input,
        rules.animations.input,
