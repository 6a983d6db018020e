# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of running nodes share: a synthetic room, a robot in it, nodes, and maps to look at."""
