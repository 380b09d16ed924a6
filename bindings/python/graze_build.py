"""The back end that builds the Python package, as PEP 517 asks for: a wheel and an archive of the sources.

It needs the standard library, CMake, a compiler and pybind11, and no network. The library is taken from the tree of the
release preset (build/release) where that is configured, so that what is built there is not built again; else from
a tree of its own, build/python, without tests and programs.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "bindings" / "python" / "graze"
# The moment that files of a wheel bear, so that the same sources make the same bytes: the first a zip file can hold.
MOMENT = (1980, 1, 1, 0, 0, 0)


def project():
    """Version and description, from the one place that has them."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"^\s*VERSION\s+([0-9.]+)\s*$", text, re.M).group(1)
    description = re.search(r'^\s*DESCRIPTION\s+"([^"]*)"', text, re.M).group(1)
    return version, description


def metadata():
    version, description = project()
    return (
        f"Metadata-Version: 2.1\nName: graze\nVersion: {version}\nSummary: {description}\nLicense: MIT\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy\nDescription-Content-Type: text/markdown\n\n"
        + (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    )


def tag():
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{interpreter}-{interpreter}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def build():
    """Builds the module; returns where it lies."""
    tree = ROOT / "build" / "release"
    if not (tree / "build.ninja").exists():
        tree = ROOT / "build" / "python"
    options = ["-DGRAZE_BUILD_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"]
    if not (tree / "build.ninja").exists():
        options += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DGRAZE_BUILD_TESTS=OFF", "-DGRAZE_BUILD_EXAMPLES=OFF"]
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(tree), *options], check=True)
    jobs = os.environ.get("JOBS", str(os.cpu_count() or 1))
    subprocess.run(["cmake", "--build", str(tree), "--target", "graze_python", "--parallel", jobs], check=True)
    return tree / "python" / "graze" / f"_graze{sysconfig.get_config_var('EXT_SUFFIX')}"


def write(archive, record, name, content, mode=0o644):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    record.append(f"{name},sha256={digest},{len(content)}")
    info = zipfile.ZipInfo(name, MOMENT)
    info.external_attr = mode << 16
    info.compress_type = zipfile.ZIP_DEFLATED
    archive.writestr(info, content)


def dist_info():
    return f"graze-{project()[0]}.dist-info"


def wheel_text():
    return f"Wheel-Version: 1.0\nGenerator: graze\nRoot-Is-Purelib: false\nTag: {tag()}\n"


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = Path(metadata_directory) / dist_info()
    folder.mkdir()
    (folder / "METADATA").write_text(metadata(), encoding="utf-8")
    (folder / "WHEEL").write_text(wheel_text(), encoding="utf-8")
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    module = build()
    name = f"graze-{project()[0]}-{tag()}.whl"
    info, record = dist_info(), []
    with zipfile.ZipFile(Path(wheel_directory) / name, "w") as archive:
        for file in sorted(p for p in PACKAGE.rglob("*") if p.suffix in (".py", ".pyi") or p.name == "py.typed"):
            write(archive, record, file.relative_to(PACKAGE.parent).as_posix(), file.read_bytes())
        # And _graze_mpi, where it was built.
        for built in sorted(module.parent.glob(f"_graze*{sysconfig.get_config_var('EXT_SUFFIX')}")):
            write(archive, record, f"graze/{built.name}", built.read_bytes(), 0o755)
        write(archive, record, f"{info}/LICENSE", (ROOT / "LICENSE").read_bytes())
        write(archive, record, f"{info}/METADATA", metadata().encode())
        write(archive, record, f"{info}/WHEEL", wheel_text().encode())
        record.append(f"{info}/RECORD,,\n")
        archive.writestr(zipfile.ZipInfo(f"{info}/RECORD", MOMENT), "\n".join(record))
    return name


def build_sdist(sdist_directory, config_settings=None):
    """What git tracks, and the metadata: needs a clone."""
    top = f"graze-{project()[0]}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout
    with tarfile.open(Path(sdist_directory) / f"{top}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in filter(None, listed.decode().split("\0")):
            archive.add(ROOT / name, f"{top}/{name}", recursive=False)
        info = ROOT / "build" / "PKG-INFO"
        info.parent.mkdir(exist_ok=True)
        info.write_text(metadata(), encoding="utf-8")
        archive.add(info, f"{top}/PKG-INFO")
    return f"{top}.tar.gz"
