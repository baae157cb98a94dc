# A recipe for Spack: put this folder as packages/repose into a repository of your own (spack repo create), and give `git` the
# address of the sources, or build a checkout of them with `spack dev-build repose@main`.
from spack.package import *

try:  # Spack 1.0 and later
    from spack_repo.builtin.build_systems.cmake import CMakePackage
except ImportError:
    pass


class Repose(CMakePackage):
    """Bulk behaviour of granular materials by the discrete element method, the same bits on any number of MPI ranks."""

    license("BSD-3-Clause")

    version("main", branch="main")

    variant("tests", default=False, description="Build the tests")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("mpi@3:")
    depends_on("hdf5@1.10: +mpi +hl")
    depends_on("eigen@3.4")
    depends_on("cli11@2:", type="build")
    depends_on("fmt@9:")
    depends_on("tomlplusplus@3:")
    depends_on("nlohmann-json@3.10:", type="build")
    depends_on("cairo+pdf+png+svg+fc")
    depends_on("leptonica")
    depends_on("libexif")
    depends_on("boost")
    depends_on("zlib-api")
    depends_on("googletest", when="+tests", type="build")
    depends_on("python@3.11:", type="run")
    depends_on("py-numpy", type="run")
    depends_on("py-h5py", type="run")
    depends_on("py-matplotlib", type="run")

    generator("ninja")
    conflicts("%clang", msg="the pair loop uses vector extensions of GCC")
    conflicts("%intel", msg="the pair loop uses vector extensions of GCC")
    conflicts("%oneapi", msg="the pair loop uses vector extensions of GCC")

    def cmake_args(self):
        return [self.define_from_variant("REPOSE_TESTS", "tests")]
