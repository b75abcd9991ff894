"""Compare with papers and other codes, and measure speed: on request only."""


rule validate:
    output:
        f"{RESULTS}/validation.xml",
    log:
        f"{RESULTS}/logs/validate.log",
    conda:
        "../envs/orthocut.yaml"
    params:
        python=sys.executable,
        sources=[digest_numbers("mpm"), digest_numbers("dem"), digest_pictures()],
    shell:
        "{params.python:q} -m pytest tests/validation --junitxml {output:q} > {log:q} 2>&1"


rule step_cost:
    output:
        f"{RESULTS}/benchmarks/step_cost.jsonl",
    log:
        f"{RESULTS}/logs/step_cost.log",
    conda:
        "../envs/orthocut.yaml"
    threads: OPTIONS.batch_cores
    params:
        python=sys.executable,
        sources=[digest_numbers("mpm"), digest_numbers("dem")],
    shell:
        "{params.python:q} benchmarks/step_cost.py > {output:q} 2> {log:q}"


rule benchmarks:
    input:
        rules.step_cost.output,
