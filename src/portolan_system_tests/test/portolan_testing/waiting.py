# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for what must come, however slow the machine is."""
import time

GENEROUS = 40.0  # [s], for what takes a fraction of a second on an idle machine


def eventually(condition, what="the condition", seconds=GENEROUS):
    """Waits until condition() is true and gives its value; fails where that never happens."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError(f"after {seconds:.0f} s still not: {what() if callable(what) else what}")
        time.sleep(0.01)
