"""Small file systems that can be filled, for tests; mounted where nobody else sees them."""

import os
import subprocess
import sys
import tempfile

SKIPPED = 77  # SKIP_RETURN_CODE of the tests


def enter_namespace():
    """Starts this test again in a mount namespace of its own, as root of a user namespace where it has to be. Skips the
    test where the system allows neither."""
    if os.environ.get("REPOSE_IN_NAMESPACE"):
        return
    for how in (["--mount"], ["--mount", "--map-root-user"]):
        prefix = ["unshare", *how, "--propagation", "private"]
        probe = [*prefix, "mount", "-t", "tmpfs", "-o", "size=4k", "tmpfs", tempfile.gettempdir()]
        if subprocess.run(probe, stderr=subprocess.DEVNULL).returncode == 0:
            allowed = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "REPOSE_IN_NAMESPACE": "1"}
            os.execvpe("unshare", [*prefix, sys.executable, *sys.argv], {**os.environ, **allowed})
    print("skipped: no rights to mount a small file system, neither as root nor in a user namespace")
    sys.exit(SKIPPED)


class SmallDisk:
    """A tmpfs of so many bytes and files (the folder of the mount is one of them)."""

    def __init__(self, size, files=0):
        self.options = f"size={size},nr_inodes={files}"

    def __enter__(self):
        self.folder = tempfile.mkdtemp()
        subprocess.run(["mount", "-t", "tmpfs", "-o", self.options, "tmpfs", self.folder], check=True)
        return self.folder

    def __exit__(self, *_):
        subprocess.run(["umount", self.folder], check=True)
        os.rmdir(self.folder)
