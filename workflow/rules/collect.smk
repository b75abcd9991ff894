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
        sources=lambda wildcards: sources_of_dataset(wildcards.figure),
        dims=lambda wildcards: dims(wildcards.figure),
        fields=lambda wildcards: draws_fields(wildcards.figure) or condense(wildcards.figure) is not None,
        store=STORE,
    script:
        "../scripts/collect.py"
