"""Join the runs of each figure into one dataset."""


rule collect:
    input:
        runs=lambda wildcards: runs_of(wildcards.figure),
    output:
        dataset=f"{RESULTS}/datasets/{{figure}}.nc",
    log:
        f"{RESULTS}/logs/collect/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=digest_datasets(),
        dims=lambda wildcards: dims(wildcards.figure),
    script:
        "../scripts/collect.py"
