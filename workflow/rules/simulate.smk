"""Simulate what the store lacks: one job a long case, one job for many short ones.

Results are no outputs: Snakemake removes the outputs of jobs that fail or start again. The mark of a batch is
temporary; a case that is in the store is no part of the DAG. A job on a cluster holds two processes of Snakemake beside
the workers, some 200 MB each: hence the 600 MB.
"""


rule simulate:
    input:
        kernels=lambda wildcards: f"{RESULTS}/kernels/{batch_of(wildcards).method}.compiled",
    output:
        temp(f"{RESULTS}/batches/{{batch}}.done"),
    log:
        f"{RESULTS}/logs/simulate/{{batch}}.log",
    priority: lambda wildcards: int(batch_of(wildcards).seconds)
    conda:
        "../envs/orthocut.yaml"
    threads: lambda wildcards: min(len(batch_of(wildcards).jobs), OPTIONS.batch_cores)
    resources:
        mem_mb=lambda wildcards, threads, attempt: attempt * (600 + threads * batch_of(wildcards).memory_mb),
        runtime=minutes,
    params:
        batch=f"{RESULTS}/batches/{{batch}}.json",
        events=f"{RESULTS}/progress/{{batch}}.jsonl",
        store=STORE,
        cluster=OPTIONS.cluster,
    script:
        "../scripts/simulate.py"


rule runs:
    input:
        missing_of(PLAN.cases),
