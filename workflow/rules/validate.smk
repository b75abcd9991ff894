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


BENCHMARKS = ("scaling", "threads", "roofline", "mpm_features", "dem_features", "skips", "stable_step", "setup_cost")


rule benchmark:
    output:
        f"{RESULTS}/benchmarks/{{name}}.csv",
    log:
        f"{RESULTS}/logs/benchmarks/{{name}}.log",
    wildcard_constraints:
        name="|".join(BENCHMARKS),
    conda:
        "../envs/orthocut.yaml"
    threads: OPTIONS.batch_cores
    params:
        python=sys.executable,
        sources=[digest_numbers("mpm"), digest_numbers("dem")],
    shell:
        "{params.python:q} benchmarks/{wildcards.name}.py --output {output:q} > {log:q} 2>&1"


rule benchmarks:
    input:
        expand(f"{RESULTS}/benchmarks/{{name}}.csv", name=BENCHMARKS),
