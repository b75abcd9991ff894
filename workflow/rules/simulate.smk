"""One job, one case, one file. Sources and libraries that can change its numbers are parameters of the job.

The kernels are no `ancient` input: Snakemake does not look at the parameters of a job whose ancient input is made anew
in the same run, and the job would keep the results of the old sources.
"""


rule simulate:
    input:
        kernels=lambda wildcards: f"{RESULTS}/kernels/{method_of(wildcards.case_id)}.compiled",
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


rule runs:
    input:
        expand(f"{RESULTS}/runs/{{case_id}}.nc", case_id=PLAN.cases),
