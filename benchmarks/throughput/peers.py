"""The programs repose is compared with: Debian's LAMMPS and LIGGGHTS, and LIGGGHTS built for this machine."""

import os
import platform
import shutil
import subprocess

SOURCES = "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian {} main\n"
FLAGS = "-O3 -march=native -std=c++11 -w"
MODEL = "GRAN_MODEL(HERTZ, TANGENTIAL_HISTORY, COHESION_OFF, ROLLING_EPSD2, SURFACE_DEFAULT)\n"
# What GCC 12 refuses; the meaning stays. The writer dump_mesh_vtk asks for VTK unconditionally and is left out.
CORRECTIONS = (("utils.h", "static_cast< std::ostringstream & >", "static_cast<const std::ostringstream &>"),
               ("finish.cpp", "->numneigh > 0)", "->numneigh != NULL)"))
WHITELISTS = ("style_contact_model.whitelist", "style_contact_model_user.whitelist")
PACKAGES = {"lmp": "lammps", "liggghts": "liggghts", "cmake": "cmake", "g++": "g++", "mpicxx": "libopenmpi-dev"}


def executable(code, prefix, repose):
    """The path of a code's executable; ends the program when it is not there."""
    path = {"repose": repose, "liggghts-native": str(prefix / "liggghts"), "liggghts-debian": "liggghts",
            "lammps": "lmp"}[code]
    found = shutil.which(path)
    if found is None:
        remedy = "give it with --repose" if code == "repose" else "`throughput.py peers` gets it"
        raise SystemExit(f"{code}: there is no executable {path}; {remedy}")
    return os.path.abspath(found)


def version(code, path):
    if code == "repose":
        return subprocess.run([path, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    lines = subprocess.run([path, "-log", "none", "-h"], capture_output=True, text=True).stdout.splitlines()
    name = next(line for line in lines if line.strip())
    return f"{name.strip()}, {FLAGS}" if code == "liggghts-native" else name.strip()


def get(prefix):
    """Installs the packages that are missing and builds LIGGGHTS below the prefix; ten minutes on one core."""
    install_packages(PACKAGES)
    if not (prefix / "liggghts").exists():
        prefix.mkdir(parents=True, exist_ok=True)
        build_liggghts(unpack_liggghts(prefix), prefix)
    for code in ("liggghts-native", "liggghts-debian", "lammps"):
        path = executable(code, prefix, None)
        print(f"{code:16s} {path}: {version(code, path)}")


def install_packages(packages):
    missing = [package for command, package in packages.items() if shutil.which(command) is None]
    if not missing:
        return
    if os.geteuid() != 0:
        raise SystemExit(f"missing packages: {' '.join(missing)}; install them, or run this as root")
    subprocess.run(["apt-get", "install", "-y", "--no-install-recommends", *missing], check=True)


def unpack_liggghts(prefix):
    """The folder of the sources, through lists of packages of our own: the machine's stay as they are."""
    (prefix / "apt/lists/partial").mkdir(parents=True, exist_ok=True)
    codename = platform.freedesktop_os_release()["VERSION_CODENAME"]
    (prefix / "apt/sources.list").write_text(SOURCES.format(codename))
    apt = ["apt-get", "-o", f"Dir::Etc::SourceList={prefix}/apt/sources.list", "-o", "Dir::Etc::SourceParts=/dev/null",
           "-o", f"Dir::State::Lists={prefix}/apt/lists"]
    subprocess.run([*apt, "update"], check=True)
    subprocess.run([*apt, "source", "--tar-only", "liggghts"], check=True, cwd=prefix)
    archive = max(prefix.glob("liggghts_*.orig.tar.*"))
    subprocess.run(["tar", "xf", archive.name], check=True, cwd=prefix)
    return max(path for path in prefix.glob("LIGGGHTS-*") if path.is_dir())


def build_liggghts(source, prefix):
    """Only the contact model of the benchmark is compiled in: LIGGGHTS makes a template instance of each listed one."""
    for name in WHITELISTS:
        (source / "src" / name).write_text(MODEL)
    for name in ("dump_mesh_vtk.cpp", "dump_mesh_vtk.h"):
        (source / "src" / name).unlink()
    for name, old, new in CORRECTIONS:
        path = source / "src" / name
        path.write_text(path.read_text().replace(old, new))
    build = prefix / "build"
    subprocess.run(["cmake", "-S", source / "src", "-B", build, "-DCMAKE_BUILD_TYPE=", f"-DCMAKE_CXX_FLAGS={FLAGS}",
                    "-DCMAKE_DISABLE_FIND_PACKAGE_VTK=ON", "-DCMAKE_DISABLE_FIND_PACKAGE_JPEG=ON"], check=True)
    subprocess.run(["nice", "-n", "5", "cmake", "--build", build, "--target", "liggghts_bin"], check=True)
    shutil.copy2(build / "liggghts", prefix / "liggghts")
