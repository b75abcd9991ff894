"""Fit the joints of glass to its stiffness and strengths: on request only, and the same for all studies.

Every test is a case in the store, so that a calibration that was interrupted goes on where it was.
"""


rule calibrate:
    input:
        kernels=f"{RESULTS}/kernels/dem.compiled",
    output:
        f"{RESULTS}/calibration/calibration.nc",
        f"{RESULTS}/calibration/joint.yaml",
        expand(
            f"{RESULTS}/calibration/{{table}}.{{form}}",
            table=("parameters", "properties", "evaluations"),
            form=("csv", "md"),
        ),
    log:
        f"{RESULTS}/logs/calibrate.log",
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
        folder=lambda wildcards, output: str(Path(output[0]).parent),
    shell:
        "{params.python:q} -m orthocut.cli calibrate --store {params.store:q} --output {params.folder:q}"
        " --workers {threads} > {log:q} 2>&1"
