# SPDX-License-Identifier: MIT
"""Builds the package for pip (PEP 517) by the standard library alone. stickslip/reference leads to the data, which are packed."""
import base64
import configparser
import hashlib
import io
import os
import pathlib
import re
import tarfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent


def _project():
    """The name with the version, the metadata and the entry points. The values of pyproject.toml are texts on one line."""
    parser = configparser.ConfigParser(inline_comment_prefixes="#")
    parser.read(HERE / "pyproject.toml", encoding="utf-8")
    project = {key: value.strip('"') for key, value in parser["project"].items()}
    version = re.search('__version__ = "(.*)"', (HERE / "stickslip/__init__.py").read_text(encoding="utf-8"))[1]
    metadata = (f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {version}\nSummary: {project['description']}\n"
                f"License: MIT\nRequires-Python: {project['requires-python']}\n")
    points = "".join(f"{key} = {value.strip(chr(34))}\n" for key, value in parser["project.entry-points.pytest11"].items())
    return f"{project['name']}-{version}", metadata, "[pytest11]\n" + points


def _files():
    """The files of the package by their paths in it, with the data, to which a link leads."""
    files = {}
    for folder, _, names in os.walk(HERE / "stickslip", followlinks=True):
        for path in (pathlib.Path(folder) / name for name in names if name.endswith((".py", ".csv", ".json", ".md"))):
            files[path.relative_to(HERE).as_posix()] = path.read_bytes()
    if "stickslip/reference/datapackage.json" not in files:
        raise FileNotFoundError("stickslip/reference has no data, but must lead to data/reference; cp -rL copies what links lead to")
    return files


def _wheel(folder, files):
    name, metadata, points = _project()
    files = {**files, f"{name}.dist-info/METADATA": metadata.encode(), f"{name}.dist-info/entry_points.txt": points.encode(),
             f"{name}.dist-info/WHEEL": b"Wheel-Version: 1.0\nGenerator: stickslip\nRoot-Is-Purelib: true\nTag: py3-none-any\n"}
    record = "".join(f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip('=')},{len(content)}\n"
                     for path, content in files.items()) + f"{name}.dist-info/RECORD,,\n"
    with zipfile.ZipFile(pathlib.Path(folder) / f"{name}-py3-none-any.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in {**files, f"{name}.dist-info/RECORD": record.encode()}.items():
            wheel.writestr(zipfile.ZipInfo(path), content, zipfile.ZIP_DEFLATED)
    return f"{name}-py3-none-any.whl"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return _wheel(wheel_directory, _files())


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return _wheel(wheel_directory, {"stickslip.pth": str(HERE).encode()})


def build_sdist(sdist_directory, config_settings=None):
    name, metadata, _ = _project()
    own = {one: (HERE / one).read_bytes() for one in ("pyproject.toml", "build_backend.py")}
    with tarfile.open(pathlib.Path(sdist_directory) / f"{name}.tar.gz", "w:gz") as archive:
        for path, content in {"PKG-INFO": metadata.encode(), **own, **_files()}.items():
            member = tarfile.TarInfo(f"{name}/{path}")
            member.size = len(content)
            archive.addfile(member, io.BytesIO(content))
    return f"{name}.tar.gz"
