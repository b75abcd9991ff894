"""Send what a job says to its log file."""

import contextlib
import os
import sys
import traceback


@contextlib.contextmanager
def logged(path):
    """Redirect stdout and stderr to a file, also those of child processes; a failure is told there and ends the job."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    saved = [os.dup(stream) for stream in (1, 2)]
    with open(path, "w", encoding="utf-8", buffering=1) as log:
        sys.stdout.flush()
        sys.stderr.flush()
        for stream in (1, 2):
            os.dup2(log.fileno(), stream)
        try:
            with contextlib.redirect_stdout(log), contextlib.redirect_stderr(log):
                yield
        except Exception as error:
            traceback.print_exc(file=log)
            print(f"{type(error).__name__}: {error}", file=log)
            raise SystemExit(1) from None
        finally:
            for stream, copy in zip((1, 2), saved, strict=True):
                os.dup2(copy, stream)
                os.close(copy)
