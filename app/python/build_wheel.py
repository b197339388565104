"""Builds the wheel with CMake: the build backend that pyproject.toml names (PEP 517). Needs nothing but the packages
of app/setup --python."""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def version():
    """The one in CMakeLists.txt."""
    with open(os.path.join(ROOT, "CMakeLists.txt")) as file:
        return re.search(r"project\(wuerfel VERSION ([0-9.]+)", file.read()).group(1)


def build_module(folder):
    """The files of the package, by their names in it."""
    def run(*command):
        subprocess.run(command, check=True, stdout=sys.stderr)

    run("cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DWUERFEL_PYTHON=ON",
        "-DWUERFEL_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}", f"-DPython_ROOT_DIR={sys.base_prefix}")
    run("cmake", "--build", folder, "--target", "wuerfel_python")
    package = os.path.join(folder, "app", "python", "wuerfel")
    return {name: os.path.join(package, name) for name in sorted(os.listdir(package))}


def platform():
    return sysconfig.get_platform().replace("-", "_").replace(".", "_")


def metadata():
    return (f"Metadata-Version: 2.1\nName: wuerfel\nVersion: {version()}\n"
            "Summary: Falling cubes in the plane by Gauss' principle of least constraint\n"
            "Requires-Python: >=3.9\nRequires-Dist: numpy\n")


def info_files():
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return {"METADATA": metadata().encode(),
            "WHEEL": f"Wheel-Version: 1.0\nGenerator: wuerfel\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-{platform()}\n".encode()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """So that nothing is built only to be asked for its name."""
    info = f"wuerfel-{version()}.dist-info"
    os.mkdir(os.path.join(metadata_directory, info))
    for name, data in info_files().items():
        with open(os.path.join(metadata_directory, info, name), "wb") as file:
            file.write(data)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """WUERFEL_BUILD names a folder that is kept, so that the next build is quick."""
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    name = f"wuerfel-{version()}-{tag}-{tag}-{platform()}.whl"
    info = f"wuerfel-{version()}.dist-info"
    with tempfile.TemporaryDirectory() as scratch:
        files = build_module(os.environ.get("WUERFEL_BUILD", scratch))
        contents = {}
        for file, path in files.items():
            with open(path, "rb") as source:
                contents[f"wuerfel/{file}"] = source.read()
    contents.update((f"{info}/{file}", data) for file, data in info_files().items())
    record = "".join(f"{path},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip('=')},{len(data)}\n"
                     for path, data in contents.items())
    contents[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in contents.items():
            wheel.writestr(zipfile.ZipInfo(path), data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("there is no source package; build from a checkout")
