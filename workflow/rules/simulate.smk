"""One job, one case, one file. Sources and libraries that can change its numbers are parameters of the job."""


rule simulate:
    input:
        kernels=lambda wildcards: ancient(f"{RESULTS}/kernels/{PLAN.cases[wildcards.case_id].kind}.compiled"),
    output:
        run=f"{RESULTS}/runs/{{case_id}}.nc",
    log:
        f"{RESULTS}/logs/simulate/{{case_id}}.log",
    priority: lambda wildcards: int(PLAN.seconds(wildcards.case_id))
    conda:
        "../envs/orthocut.yaml"
    resources:
        mem_mb=1500,
        runtime=lambda wildcards: 10 + int(PLAN.seconds(wildcards.case_id) / 20),
    params:
        case=lambda wildcards: canonical(PLAN.cases[wildcards.case_id]),
        sources=lambda wildcards: digest_numbers(PLAN.cases[wildcards.case_id].kind),
    script:
        "../scripts/simulate.py"
