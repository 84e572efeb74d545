# SPDX-License-Identifier: MIT
"""Builds the wheel (PEP 517) for the Python that runs this, with CMake and nothing else.

The wheel is for this machine: it finds Embree, Bullet and the like where Debian has put them.
    python build_backend.py configure    makes the build folder one for this Python
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
PACKAGE = BUILD / "python" / "bulletnav"


class BuildError(SystemExit):
    """Ends with one line."""

    def __init__(self, what):
        super().__init__(f"bulletnav: error: {what}")


def _require_python():
    name = f"{sys.implementation.name} {sys.version_info[0]}.{sys.version_info[1]}"
    if sys.implementation.name != "cpython" or sys.version_info < (3, 8):
        raise BuildError(f"{sys.executable} is {name}; CPython 3.8 or later is needed")
    header = pathlib.Path("/usr/include/pybind11/detail/common.h")
    if sys.version_info >= (3, 12) and header.exists():
        version = re.findall(r"PYBIND11_VERSION_M(?:AJOR|INOR) (\d+)", header.read_text())
        if tuple(map(int, version)) < (2, 11):
            raise BuildError(f"{sys.executable} is {name}, of which this machine's pybind11 "
                             f"{'.'.join(version)} does not know; Debian's will do: "
                             "/usr/bin/python3 -m venv FOLDER")
    include = pathlib.Path(sysconfig.get_path("include"))
    if not (include / "Python.h").exists():
        raise BuildError(f"{include}/Python.h is missing: install the headers of "
                         f"{sys.executable} (Debian: apt-get install python3-dev)")


def _suffix():
    return sysconfig.get_config_var("EXT_SUFFIX")


def _cached(name):
    cache = BUILD / "CMakeCache.txt"
    found = re.search(rf"^{name}:\w+=(.*)$", cache.read_text(), re.M) if cache.exists() else None
    return found[1] if found else None


def _suffix_of(python):
    """Of another interpreter; None if it is gone."""
    ask = "import sysconfig; print(sysconfig.get_config_var('EXT_SUFFIX'))"
    try:
        done = subprocess.run([python, "-c", ask], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return None
    return done.stdout.strip()


def _run(command):
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode != 0:
        sys.stderr.write("\n".join(done.stdout.splitlines()[-20:]) + "\n")
        raise BuildError(f"{' '.join(command)} failed; ./bulletnav python installs what it needs")


def configure():
    """The build folder, for this Python. One for another Python of the same ABI will do."""
    _require_python()
    if (BUILD / "build.ninja").exists() and _cached("BULLETNAV_PYTHON") == "ON":
        before = _cached("BULLETNAV_PYTHON_EXECUTABLE")
        if before and _suffix_of(before) == _suffix():
            return
    # A virtual environment may go away, what it was made of stays.
    python = os.path.realpath(sys.executable)
    _run(["cmake", "--preset", "release", "-DBULLETNAV_PYTHON=ON",
          f"-DBULLETNAV_PYTHON_EXECUTABLE={python}"])


def _build():
    configure()
    _run(["cmake", "--build", str(BUILD), "--target", "bulletnav_python",
          "--parallel", str(os.cpu_count() or 1)])


def _version():
    text = (ROOT / "CMakeLists.txt").read_text()
    return re.search(r"project\(bulletnav VERSION ([\d.]+)", text)[1]


def _metadata():
    return (f"Metadata-Version: 2.1\nName: bulletnav\nVersion: {_version()}\n"
            "Summary: Embodied navigation in 3D scenes: simulator, environments, results\n"
            "License: MIT\nRequires-Python: >=3.8\n")


def _tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _dist_info():
    return f"bulletnav-{_version()}.dist-info"


def _contents():
    """(name in the wheel, bytes, whether it is a program)."""
    for file in sorted((ROOT / "python" / "bulletnav").iterdir()):
        if file.suffix in (".py", ".pyi", ".typed"):
            yield f"bulletnav/{file.name}", file.read_bytes(), False
    core = f"_core{_suffix()}"
    yield f"bulletnav/{core}", (PACKAGE / core).read_bytes(), False
    for program in ("bulletnav-import", "bulletnav-import-sdf"):  # the second is an option
        if (BUILD / program).exists():
            yield f"bulletnav/{program}", (BUILD / program).read_bytes(), True
    wheel = f"Wheel-Version: 1.0\nGenerator: bulletnav\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    yield f"{_dist_info()}/METADATA", _metadata().encode(), False
    yield f"{_dist_info()}/WHEEL", wheel.encode(), False
    yield f"{_dist_info()}/LICENSE", (ROOT / "LICENSE").read_bytes(), False


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """PEP 517: writes the wheel, returns its name."""
    del config_settings, metadata_directory
    _build()
    name = f"bulletnav-{_version()}-{_tag()}.whl"
    record = []
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w",
                         zipfile.ZIP_DEFLATED) as archive:

        def add(path, content, is_program=False):
            entry = zipfile.ZipInfo(path)  # Of 1980: the same wheel from the same files.
            entry.external_attr = (0o100755 if is_program else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)

        for path, content, is_program in _contents():
            add(path, content, is_program)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=")
            record.append(f"{path},sha256={digest.decode()},{len(content)}")
        record.append(f"{_dist_info()}/RECORD,,")
        add(f"{_dist_info()}/RECORD", ("\n".join(record) + "\n").encode())
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """PEP 517: without a build."""
    del config_settings
    folder = pathlib.Path(metadata_directory) / _dist_info()
    folder.mkdir()
    (folder / "METADATA").write_text(_metadata())
    return folder.name


def get_requires_for_build_wheel(config_settings=None):
    """PEP 517."""
    del config_settings
    return []


def build_sdist(sdist_directory, config_settings=None):
    """PEP 517: there is none."""
    del sdist_directory, config_settings
    raise BuildError("there is no source archive; the checkout is the source")


if __name__ == "__main__":
    if sys.argv[1:] != ["configure"]:
        raise BuildError("use: build_backend.py configure; wheels are built by pip")
    configure()
