"""Join the runs of each figure into one dataset."""


rule collect:
    input:
        runs=lambda wildcards: runs_of(wildcards.figure),
    output:
        dataset=f"{RESULTS}/datasets/{{figure}}.nc",
    log:
        f"{RESULTS}/logs/collect/{{figure}}.log",
    params:
        sources=digest_datasets(),
    conda:
        "../envs/orthocut.yaml"
    script:
        "../scripts/collect.py"
