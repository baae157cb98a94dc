# shellcheck shell=sh
# Settings of Open MPI and its hwloc for one machine, a container or CI: `. tools/environment.sh` before mpirun. What is
# already set stays. On a cluster the batch system takes care of all this; do not source it there.

# Ranks beyond the number of cores are allowed: the tests use up to 8 ranks on any machine.
export OMPI_MCA_rmaps_base_oversubscribe="${OMPI_MCA_rmaps_base_oversubscribe:-1}"

# No binding to cores: two jobs at the same time (ctest -j) would both be bound to the first cores.
export OMPI_MCA_hwloc_base_binding_policy="${OMPI_MCA_hwloc_base_binding_policy:-none}"

# A waiting rank gives up its core: others may be waiting for it.
export OMPI_MCA_mpi_yield_when_idle="${OMPI_MCA_mpi_yield_when_idle:-1}"

# Containers forbid reading another process's memory (process_vm_readv); Open MPI would warn in every run.
if [ -e /.dockerenv ] || [ -e /run/.containerenv ] || [ -n "${container:-}" ]; then
  export OMPI_MCA_btl_vader_single_copy_mechanism="${OMPI_MCA_btl_vader_single_copy_mechanism:-none}"
fi

# No search for X displays at the start of every rank: without a local host name it waits seconds for name servers.
export HWLOC_COMPONENTS="${HWLOC_COMPONENTS:--gl}"

# mpirun refuses to work for root unless told twice; in a container or CI root is the only user.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
