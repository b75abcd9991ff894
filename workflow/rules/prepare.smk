"""Compile the kernels of each method once, before many jobs at a time need them."""


rule warm:
    output:
        touch(f"{RESULTS}/kernels/{{method}}.compiled"),
    log:
        f"{RESULTS}/logs/warm/{{method}}.log",
    priority: 1000
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=lambda wildcards: digest_numbers(wildcards.method),
    script:
        "../scripts/warm.py"
