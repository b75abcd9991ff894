"""Cost of a step with bonded discs for several numbers of discs; prints one JSON object a line."""

import json

from orthocut.experiments.speed_dem import bench_dem

if __name__ == "__main__":
    for discs in (500, 2085, 7406, 29_624):
        print(json.dumps(bench_dem(discs=discs, steps=max(200, 6_000_000 // discs))), flush=True)
