"""Send what a job says to its log file."""

import contextlib
import traceback


@contextlib.contextmanager
def logged(path):
    """Redirect stdout and stderr to a file; a failure is told there too, and ends the job without more words."""
    with open(path, "w", encoding="utf-8") as log, contextlib.redirect_stdout(log), contextlib.redirect_stderr(log):
        try:
            yield
        except Exception as error:
            traceback.print_exc()
            print(f"{type(error).__name__}: {error}")
            log.flush()
            raise SystemExit(1) from None
