"""Join the results of each figure into one dataset."""


rule collect:
    input:
        lambda wildcards: missing_of(PLAN.figures[wildcards.figure]),
    output:
        dataset=f"{RESULTS}/datasets/{{figure}}.nc",
    log:
        f"{RESULTS}/logs/collect/{{figure}}.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        members=lambda wildcards: members_of(PLAN.figures[wildcards.figure]),
        sources=digest_datasets(),
        dims=lambda wildcards: dims(wildcards.figure),
        fields=lambda wildcards: draws_fields(wildcards.figure),
        store=STORE,
    script:
        "../scripts/collect.py"
