"""Fit the joints of glass to its stiffness and strengths: on request only, and the same for all studies.

First on small specimens, with the uncertainty of the fit, then, from there, on specimens of the paper's size. Every test
is a case in the store, so that a calibration that was interrupted goes on where it was.
"""

CALIBRATION_TABLES = [
    f"{table}.{form}" for table in ("parameters", "properties", "evaluations") for form in ("csv", "md")
]


rule calibrate_small:
    input:
        kernels=f"{RESULTS}/kernels/dem.compiled",
    output:
        f"{RESULTS}/calibration/calibration.nc",
        joint=f"{RESULTS}/calibration/joint.yaml",
        tables=expand(f"{RESULTS}/calibration/{{table}}", table=CALIBRATION_TABLES),
    log:
        f"{RESULTS}/logs/calibrate_small.log",
    conda:
        "../envs/orthocut.yaml"
    threads: OPTIONS.batch_cores
    resources:
        mem_mb=lambda wildcards, threads, attempt: attempt * (600 + 600 * threads),
        runtime=120,
    params:
        python=sys.executable,
        sources=[digest_numbers("dem_tension"), digest_numbers("dem_compression")],
        store=STORE,
        folder=lambda wildcards, output: str(Path(output.joint).parent),
    shell:
        "{params.python:q} -m orthocut.cli calibrate --store {params.store:q} --output {params.folder:q}"
        " --workers {threads} > {log:q} 2>&1"


rule calibrate_paper:
    input:
        joint=rules.calibrate_small.output.joint,
    output:
        f"{RESULTS}/calibration/paper_size/calibration.nc",
        joint=f"{RESULTS}/calibration/paper_size/joint.yaml",
        tables=expand(f"{RESULTS}/calibration/paper_size/{{table}}", table=CALIBRATION_TABLES),
    log:
        f"{RESULTS}/logs/calibrate_paper.log",
    conda:
        "../envs/orthocut.yaml"
    threads: OPTIONS.batch_cores
    resources:
        mem_mb=lambda wildcards, threads, attempt: attempt * (600 + 700 * threads),
        runtime=240,
    params:
        python=sys.executable,
        sources=[digest_numbers("dem_tension"), digest_numbers("dem_compression")],
        store=STORE,
        folder=lambda wildcards, output: str(Path(output.joint).parent),
        size="--set 'packing.width=1 mm' --set 'packing.height=2 mm' --set 'packing.radius_min=7.5 um'",
    shell:
        "{params.python:q} -m orthocut.cli calibrate {input.joint:q} {params.size} --set replicates=3"
        " --set uncertainty=false --store {params.store:q} --output {params.folder:q} --workers {threads}"
        " > {log:q} 2>&1"


rule calibrate:
    input:
        rules.calibrate_small.output,
        rules.calibrate_paper.output,
