"""Compile the kernels of each method once, before many jobs at a time need them."""


rule warm:
    output:
        touch(f"{RESULTS}/kernels/{{kind}}.compiled"),
    log:
        f"{RESULTS}/logs/warm/{{kind}}.log",
    priority: 1000
    conda:
        "../envs/orthocut.yaml"
    params:
        sources=lambda wildcards: digest_numbers(wildcards.kind),
    script:
        "../scripts/warm.py"
