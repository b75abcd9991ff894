"""A run that leaves the range of its own assumptions stops, with a diagnosis."""

from orthocut.params.block import CaseFailed


class Diverged(CaseFailed):
    """The numbers of a run can no longer be trusted; the message says what was seen, when and what to try."""
