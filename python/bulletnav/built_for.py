# SPDX-License-Identifier: MIT
"""Which Python this package is for."""
import pathlib
import sys
import sysconfig

_HERE = pathlib.Path(__file__).absolute().parent  # not what a link points to


def require(folder=_HERE, suffix=sysconfig.get_config_var("EXT_SUFFIX")):
    """Raises ImportError, in one line, where the extension is there for other Pythons alone."""
    if (folder / f"_core{suffix}").exists():
        return
    version = f"{sys.implementation.name} {sys.version_info[0]}.{sys.version_info[1]}"
    others = sorted(file.name.split(".")[1] for file in folder.glob("_core.*.so"))
    built = f"is built for {', '.join(others)}" if others else "has no extension"
    raise ImportError(f"bulletnav in {folder} {built}, and this is {version} ({sys.executable}): "
                      "run ./bulletnav python in a virtual environment of this Python")
