# SPDX-License-Identifier: MIT
"""Gymnasium's spaces where it is installed, else small ones of the same behaviour."""
try:
    from gymnasium.spaces import Box, Dict, Discrete, MultiDiscrete
except ImportError:
    from bulletnav.own_spaces import Box, Dict, Discrete, MultiDiscrete

__all__ = ["Box", "Dict", "Discrete", "MultiDiscrete"]
